// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/base/error.h"
#include "renderer/technique/variant_setting.h"

namespace obscura::app {
const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> list = {
        front(),          jakobsen_order(),       whinham_samples(),   sunet_pipelines(),
        sunet_depth(),    sunet_reconstruction(), sunet_positions(),   sunet_normals(),
        sunet_blur(),     sunet_methods(),        sunet_progressive(), hussain_performance(),
        hussain_quality()};
    return list;
}

const Experiment* find_experiment(const std::string& name) {
    for (const Experiment& experiment : experiments()) {
        if (experiment.name == name) return &experiment;
    }
    return nullptr;
}

std::string experiments_text() {
    std::string text;
    for (const Experiment& experiment : experiments()) {
        text += fmt::format("{:15} {}\n", experiment.name, experiment.title);
    }
    return text;
}

renderer::Variant setting_of(const std::string& technique, int samples, const std::string& denoise,
                             const std::vector<std::string>& values) {
    renderer::Variant variant;
    variant.technique = technique;
    variant.samples = samples;
    variant.denoise = denoise;
    for (const std::string& value : values) {
        if (!renderer::set(variant, value)) throw base::failure("{} is no setting", value);
    }
    for (const renderer::VariantProblem& problem : renderer::problems_of(variant)) {
        throw base::failure("{}: {}: {}", technique, problem.key, problem.message);
    }
    return variant;
}

const Outcome& outcome_of(const std::vector<Outcome>& outcomes, const std::string& name) {
    const auto found =
        std::find_if(outcomes.begin(), outcomes.end(),
                     [&name](const Outcome& outcome) { return outcome.name == name; });
    assert(found != outcomes.end());
    return *found;
}

double share_apart(double first_ms, double second_ms) {
    return std::abs(first_ms - second_ms) / std::max(first_ms, second_ms);
}

std::string in_order(const std::vector<Outcome>& outcomes, double Outcome::*value) {
    std::vector<const Outcome*> sorted;
    for (const Outcome& outcome : outcomes) {
        if (!std::isnan(outcome.*value)) sorted.push_back(&outcome);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [value](const Outcome* a, const Outcome* b) { return a->*value < b->*value; });
    std::string text;
    for (const Outcome* outcome : sorted) {
        text +=
            fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", outcome->name, outcome->*value);
    }
    return text;
}

}  // namespace obscura::app
