// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_order(const std::vector<Outcome>& outcomes) {
    const double crytek = outcome_of(outcomes, "crytek").rmse;
    const double blizzard = outcome_of(outcomes, "blizzard").rmse;
    const double raymarch = outcome_of(outcomes, "raymarch").rmse;
    const std::string errors = "RMSE: " + in_order(outcomes, &Outcome::rmse);
    return {{"Blizzard's shows less self-occlusion and more detail than Crytek's",
             blizzard < crytek, errors},
            {"ray marching finds more detail than Blizzard's, with less self-occlusion",
             raymarch < blizzard, errors}};
}

}  // namespace

Experiment jakobsen_order() {
    return {"jakobsen-4.3.4",
            "Jakobsen 2010, 4.3.4: the three techniques in the order of their accuracy",
            {{"crytek", setting_of("crytek", 24, "separable")},
             {"blizzard", setting_of("blizzard", 24, "separable")},
             {"raymarch", setting_of("raymarch", 30, "separable")}},
            judge_order,
            ""};
}

}  // namespace obscura::app
