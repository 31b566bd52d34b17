// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_depth(const std::vector<Outcome>& outcomes) {
    const Outcome& half = outcome_of(outcomes, "16 bits");
    const Outcome& full = outcome_of(outcomes, "32 bits");
    const double apart = std::abs(half.rmse - full.rmse);
    const double half_ms = half.ao_ms + half.filter_ms;
    const double full_ms = full.ao_ms + full.filter_ms;
    return {{"between 16 and 32 bits of linear depth the difference in quality is negligible",
             apart < 0.005,
             fmt::format("RMSE {:.4f} and {:.4f}, {:.4f} apart", half.rmse, full.rmse, apart)},
            {"32 bits cost little more time than 16", full_ms < 1.1 * half_ms,
             fmt::format("{:.2f} and {:.2f} ms of accessibility and filter", full_ms, half_ms)}};
}

}  // namespace

Experiment sunet_depth() {
    return {"sunet-5.3",
            "Sunet 2018, 5.3: how precise the depth buffer has to be, with Alchemy",
            {{"16 bits", setting_of("alchemy", 16, "separable", {"depth_format=r16f"})},
             {"32 bits", setting_of("alchemy", 16, "separable")},
             {"24 bits, of the depth test",
              setting_of("alchemy", 16, "separable", {"depth_format=d24"})}},
            judge_depth,
            "the paper's 8 bits, which it found unacceptable, are no format here"};
}

}  // namespace obscura::app
