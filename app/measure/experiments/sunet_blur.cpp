// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_blur(const std::vector<Outcome>& outcomes) {
    const Outcome& full = outcome_of(outcomes, "bilateral");
    const Outcome& separable = outcome_of(outcomes, "separable");
    return {
        {"the separable blur is faster than the bilateral filter, though it takes a pass more",
         separable.filter_ms < full.filter_ms,
         fmt::format("{:.2f} and {:.2f} ms, a factor of {:.2f} (the paper: 2.35)",
                     separable.filter_ms, full.filter_ms, full.filter_ms / separable.filter_ms),
         share_apart(separable.filter_ms, full.filter_ms)},
        {"the difference in quality is negligible", std::abs(separable.rmse - full.rmse) < 0.005,
         fmt::format("RMSE {:.4f} and {:.4f}, without a filter {:.4f}", separable.rmse, full.rmse,
                     outcome_of(outcomes, "none").rmse)}};
}

}  // namespace

Experiment sunet_blur() {
    return {"sunet-5.7",
            "Sunet 2018, 5.7: the bilateral filter against the separable blur, with Alchemy",
            {{"none", setting_of("alchemy", 16, "none")},
             {"bilateral", setting_of("alchemy", 16, "bilateral")},
             {"separable", setting_of("alchemy", 16, "separable")}},
            judge_blur,
            ""};
}

}  // namespace obscura::app
