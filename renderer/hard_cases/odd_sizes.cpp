// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <utility>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Case 13. Sizes that are no multiple of anything; the largest is left out where images are small.
void run_odd_sizes(Bench& bench, const Technique& technique) {
    const bool large = bench.options().size_px >= 128 && !technique.ray_traced;
    for (const auto& [width, height] : {std::pair(1, 1), {17, 9}, {3, 200}, {1921, 1081}}) {
        if (width > 1000 && !large) continue;
        Variant choice = Bench::settings(technique, 0.3);
        if (!technique.ray_traced) choice.denoise = "separable";
        for (const std::string& scale : find_option("ao_scale")->allowed) {
            choice.ao_scale = scale;
            if (!problems_of(choice).empty() || (width > 1000 && scale == "0.25")) continue;
            const std::string what = fmt::format("{}x{}, ao_scale {}", width, height, scale);
            const Shot shot =
                bench.shoot(what, shapes::clutter(), shapes::camera(5.0F), choice, width, height);
            bench.expect_sound(what, shot);
        }
    }
}

}  // namespace

HardCase odd_sizes_case() { return {13, "odd sizes", run_odd_sizes}; }

}  // namespace obscura::renderer
