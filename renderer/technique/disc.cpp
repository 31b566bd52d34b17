// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/disc.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {

std::vector<DiscPoint> disc_kernel(int count) {
    const double golden_rad = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<DiscPoint> points;
    for (int i = 0; i < count; ++i) {
        const double length = std::sqrt((i + 0.5) / count);
        points.push_back({static_cast<float>(length * std::cos(golden_rad * i)),
                          static_cast<float>(length * std::sin(golden_rad * i))});
    }
    return points;
}

Recipe disc_recipe(const Variant& variant, const std::string& shader, int reads_per_sample) {
    Recipe recipe;
    recipe.tables = {turn_table(2.0 * std::numbers::pi, variant.noise)};
    // Each sample's texels; the pixel's own depth, normal and turn.
    Step step = accessibility_step(variant, shader, {Target::kDepth, Target::kNormal, "turns"},
                                   reads_per_sample * samples_of_frame(variant) + 3);
    std::string points;
    for (const DiscPoint& point : part_of(disc_kernel(variant.samples), variant)) {
        points +=
            fmt::format("{}vec2({:.9e}, {:.9e})", points.empty() ? "" : ", ", point.x, point.y);
    }
    step.defines.push_back(fmt::format("DISC vec2[]({})", points));
    recipe.steps = {step};
    return recipe;
}

}  // namespace obscura::renderer
