// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_reconstruction(const std::vector<Outcome>& outcomes) {
    const Outcome& triangles = outcome_of(outcomes, "similar triangles");
    const Outcome& inverse = outcome_of(outcomes, "inverse projection");
    const double apart = std::abs(triangles.rmse - inverse.rmse);
    return {
        {"the difference in quality is negligible", apart < 0.001,
         fmt::format("RMSE {:.5f} and {:.5f}, {:.5f} apart", triangles.rmse, inverse.rmse, apart)},
        {"similar triangles are slightly faster", triangles.ao_ms < inverse.ao_ms,
         fmt::format("{:.2f} and {:.2f} ms, a factor of {:.2f} (the paper: 1.11)", triangles.ao_ms,
                     inverse.ao_ms, inverse.ao_ms / triangles.ao_ms),
         share_apart(triangles.ao_ms, inverse.ao_ms)}};
}

}  // namespace

Experiment sunet_reconstruction() {
    return {"sunet-5.4",
            "Sunet 2018, 5.4: points from depth by similar triangles or the projection's inverse, "
            "with Alchemy",
            {{"similar triangles", setting_of("alchemy", 16, "separable")},
             {"inverse projection",
              setting_of("alchemy", 16, "separable", {"position=inverse-projection"})}},
            judge_reconstruction,
            ""};
}

}  // namespace obscura::app
