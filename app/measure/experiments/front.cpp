// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

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

/// Whether a technique nobody had before is nearer to the truth than every one of the papers'.
std::vector<Finding> judge_front(const std::vector<Outcome>& outcomes) {
    const Outcome* blizzard = nullptr;
    const Outcome* best = nullptr;
    for (const Outcome& outcome : outcomes) {
        if (std::isnan(outcome.rmse)) continue;
        if (outcome.name == "Blizzard24") blizzard = &outcome;
        const bool traced = outcome.name.starts_with("RayTraced");
        if (!traced && (best == nullptr || outcome.rmse < best->rmse)) best = &outcome;
    }
    if (blizzard == nullptr || best == nullptr) return {};
    return {{"Blizzard's is the best accuracy for its time", best == blizzard,
             fmt::format("RMSE {:.4f} at {:.2f} ms; {} has {:.4f} at {:.2f} ms, the least without "
                         "rays",
                         blizzard->rmse, blizzard->ao_ms + blizzard->filter_ms, best->name,
                         best->rmse, best->ao_ms + best->filter_ms)}};
}

}  // namespace

Experiment front() {
    Experiment experiment{"front",
                          "All techniques: error over time, as published and fitted",
                          {},
                          judge_front,
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
