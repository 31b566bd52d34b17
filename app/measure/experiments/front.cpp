// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

/// Sample counts beside a technique's own, and steps a side where they are not its own.
struct More {
    const char* technique;
    int samples;
    int steps = 0;
};
constexpr More kMore[] = {{"blizzard", 8}, {"blizzard", 64}, {"hbao", 32},       {"gtao", 8},
                          {"gtao", 24},    {"gtao", 64, 8},  {"bitmask", 12, 6}, {"bitmask", 24},
                          {"layered", 24}, {"raytraced", 1}, {"raytraced", 16}};

void add(Experiment& experiment, const renderer::Technique& technique, int samples, int steps) {
    renderer::Variant variant;
    variant.technique = technique.name;
    variant.samples = samples;
    variant.denoise = renderer::standard_denoise(technique);
    if (steps > 0) variant.parameters["steps"] = steps;
    std::string name = variant.variant_name();
    if (steps > 0) name += fmt::format(" {} steps", steps);
    if (steps == 0) experiment.settings.push_back({name, variant, Values::kPublished});
    if (technique.fitted.empty()) return;
    (void)renderer::apply_preset("fitted", variant);
    experiment.settings.push_back({name, variant, Values::kFitted});
}

}  // namespace

Experiment front() {
    Experiment experiment{"front",
                          "All techniques: error over time, as published and fitted",
                          {},
                          nullptr,
                          "whether a difference in error is one that people see"};
    for (const renderer::Technique& technique : renderer::techniques()) {
        if (technique.is_truth()) continue;
        add(experiment, technique, technique.samples.standard, 0);
        for (const More& more : kMore) {
            if (more.technique == technique.name) {
                add(experiment, technique, more.samples, more.steps);
            }
        }
    }
    experiment.overview = true;
    return experiment;
}

}  // namespace obscura::app
