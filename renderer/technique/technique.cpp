// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/technique.h"

#include <fmt/format.h>

#include <cmath>

#include "renderer/denoise/denoise.h"

namespace obscura::renderer {
namespace {

template <typename List>
std::string names_of(const List& list) {
    std::string names;
    for (const auto& item : list) names += (names.empty() ? "" : ", ") + item.name;
    return names.empty() ? "none" : names;
}

void check_samples(const Technique& technique, int samples, std::vector<ChoiceProblem>& problems) {
    const SampleRange& range = technique.samples;
    if (samples < range.low || samples > range.high) {
        problems.push_back(
            {"samples",
             range.high == 0
                 ? fmt::format("{} is not allowed: {} takes no samples", samples, technique.name)
                 : fmt::format("{} is out of range: {} takes {} to {}", samples, technique.name,
                               range.low, range.high)});
    } else if (samples % range.multiple_of != 0) {
        problems.push_back({"samples", fmt::format("{} is not allowed: {} takes multiples of {}",
                                                   samples, technique.name, range.multiple_of)});
    }
}

}  // namespace

const Parameter* Technique::find_parameter(std::string_view parameter_name) const {
    for (const Parameter& parameter : parameters) {
        if (parameter.name == parameter_name) return &parameter;
    }
    return nullptr;
}

std::string Technique::why_not(Ideal ideal) const {
    const auto found = by_nature.find(ideal);
    return found != by_nature.end() ? found->second : "";
}

const Technique* find_technique(std::string_view name) {
    for (const Technique& technique : techniques()) {
        if (technique.name == name) return &technique;
    }
    return nullptr;
}

std::string TechniqueChoice::variant_name() const {
    const Technique* found = find_technique(technique);
    const std::string stem = found != nullptr ? found->variant : technique;
    return samples > 0 ? stem + std::to_string(samples) : stem;
}

double TechniqueChoice::value_of(const Parameter& parameter) const {
    const auto set = parameters.find(parameter.name);
    return set != parameters.end() ? set->second : parameter.standard;
}

int fetches_per_pixel(const TechniqueChoice& choice) {
    const Technique* technique = find_technique(choice.technique);
    const Denoise* denoise = find_denoise(choice.denoise);
    if (technique == nullptr || technique->shader.empty()) return 0;
    const int each = technique->fetches_per_sample + (technique->reads_normal ? 1 : 0);
    const int once = 2 + (technique->reads_normal ? 1 : 0);
    return choice.samples * each + once + (denoise != nullptr ? denoise->fetches : 0);
}

std::vector<ChoiceProblem> problems_of(const TechniqueChoice& choice) {
    std::vector<ChoiceProblem> problems;
    const Technique* technique = find_technique(choice.technique);
    if (technique == nullptr) {
        return {{"technique", fmt::format("\"{}\" is unknown; allowed are {}", choice.technique,
                                          names_of(techniques()))}};
    }
    check_samples(*technique, choice.samples, problems);
    if (find_denoise(choice.denoise) == nullptr) {
        problems.push_back({"denoise", fmt::format("\"{}\" is unknown; allowed are {}",
                                                   choice.denoise, names_of(denoise_filters()))});
    }
    if (choice.depth_format != "r32f" && choice.depth_format != "r16f") {
        problems.push_back({"depth_format", fmt::format("\"{}\" is unknown; allowed are r32f, r16f",
                                                        choice.depth_format)});
    }
    for (const auto& [name, value] : choice.parameters) {
        const Parameter* parameter = technique->find_parameter(name);
        if (parameter == nullptr) {
            problems.push_back(
                {name, fmt::format("{} has no such parameter; allowed are {}", technique->name,
                                   names_of(technique->parameters))});
        } else if (!(value >= parameter->low && value <= parameter->high)) {
            problems.push_back(
                {name, fmt::format("{} is out of range: allowed is {} to {}{}{}", value,
                                   parameter->low, parameter->high,
                                   parameter->unit.empty() ? "" : " ", parameter->unit)});
        } else if (parameter->whole && value != std::floor(value)) {
            problems.push_back({name, fmt::format("{} is not a whole number from {} to {}", value,
                                                  parameter->low, parameter->high)});
        }
    }
    return problems;
}

}  // namespace obscura::renderer
