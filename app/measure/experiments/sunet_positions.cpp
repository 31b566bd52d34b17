// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

constexpr const char* kWithPoints[] = {"alchemy", "hbao", "starcraft2"};

/// Geometry and accessibility, which the paper adds.
double geometry_and_ao_ms(const Outcome& outcome) {
    double sum_ms = outcome.ao_ms;
    for (const char* pass : {"geometry", "occluders"}) {
        const auto found = outcome.house_ms.find(pass);
        if (found != outcome.house_ms.end()) sum_ms += found->second;
    }
    return sum_ms;
}

std::vector<Finding> judge_positions(const std::vector<Outcome>& outcomes) {
    bool nearly_all = true;
    double most_apart = 0.0;
    std::string times;
    std::string errors;
    for (const std::string technique : kWithPoints) {
        const Outcome& depth = outcome_of(outcomes, technique + ", depth");
        const Outcome& stored = outcome_of(outcomes, technique + ", position");
        const bool faster = geometry_and_ao_ms(depth) < geometry_and_ao_ms(stored);
        nearly_all &= faster == (technique != "starcraft2");
        times += fmt::format("{}{} {:.2f} and {:.2f} ms", times.empty() ? "" : ", ", technique,
                             geometry_and_ao_ms(depth), geometry_and_ao_ms(stored));
        most_apart = std::max(most_apart, std::abs(depth.rmse - stored.rmse));
        errors += fmt::format("{}{} {:.4f} and {:.4f}", errors.empty() ? "" : ", ", technique,
                              depth.rmse, stored.rmse);
    }
    return {{"with a depth buffer all but StarCraft II are slightly faster, which is slower",
             nearly_all, "geometry and accessibility: " + times},
            {"either may be taken, as it comes out on one's platform", most_apart < 0.005,
             "RMSE " + errors}};
}

}  // namespace

Experiment sunet_positions() {
    Experiment experiment{
        "sunet-5.5",
        "Sunet 2018, 5.5: points stored in place of depth, 16 bits a component",
        {},
        judge_positions,
        "Crytek, which works in the image here and needs no points; and the paper's saving of the "
        "depth, which stays here for the filter and for what a sample is held against"};
    for (const std::string technique : kWithPoints) {
        experiment.settings.push_back(
            {technique + ", depth", setting_of(technique, 16, "separable", {"depth_format=r16f"})});
        experiment.settings.push_back(
            {technique + ", position",
             setting_of(technique, 16, "separable", {"depth_format=r16f", "position=stored"})});
    }
    return experiment;
}

}  // namespace obscura::app
