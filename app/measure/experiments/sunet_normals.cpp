// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_normals(const std::vector<Outcome>& outcomes) {
    const Outcome& three = outcome_of(outcomes, "three components");
    const Outcome& two = outcome_of(outcomes, "two components");
    const Outcome& rebuilt = outcome_of(outcomes, "rebuilt from depth");
    return {{"two components save nothing: the shader that rebuilds the third is no faster",
             two.ao_ms > 0.97 * three.ao_ms,
             fmt::format("{:.2f} ms with two, {:.2f} ms with three", two.ao_ms, three.ao_ms)},
            {"two components look the same as three", std::abs(two.rmse - three.rmse) < 0.005,
             fmt::format("RMSE {:.4f} and {:.4f}; octahedral {:.4f}, from depth {:.4f}", two.rmse,
                         three.rmse, outcome_of(outcomes, "octahedral").rmse, rebuilt.rmse)}};
}

}  // namespace

Experiment sunet_normals() {
    return {"sunet-5.6",
            "Sunet 2018, 5.6: normals in two components, with Alchemy",
            {{"three components", setting_of("alchemy", 16, "separable")},
             {"two components", setting_of("alchemy", 16, "separable", {"normal_format=rg8"})},
             {"octahedral", setting_of("alchemy", 16, "separable", {"normal_format=oct16"})},
             {"rebuilt from depth",
              setting_of("alchemy", 16, "separable", {"normal_format=from-depth"})}},
            judge_normals,
            "the bandwidth that two components save in the geometry pass: the image's own normals "
            "stay in three"};
}

}  // namespace obscura::app
