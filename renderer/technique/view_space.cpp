// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/view_space.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"

namespace obscura::renderer {

std::vector<Parameter> view_space_parameters() {
    // The thesis gives no values for its "artistic variables" (4.3.2.3); these are Obscura's.
    return {
        {"radius_m", "Distance to which surfaces are taken into account", "m", 0.0, 1000.0, 0.5},
        {"full_threshold_m", "A depth difference below this does not occlude", "m", 0.0, 1000.0,
         0.02},
        {"no_threshold_m", "A depth difference above this does not occlude", "m", 0.0, 10000.0,
         2.0},
        {"depth_scale_per_m",
         "Factor of a depth difference before its curve: scale it with the scene's units", "1/m",
         0.0, 1.0e9, 1.0, false, false},
        {"power", "Exponent of the accessibility of one occluded sample", "", 0.0, 10000.0, 16.0},
    };
}

namespace {

/// How often a number is squared to give its power, where that is all it takes: quicker than pow()
/// and nearer to the truth.
std::optional<int> squarings_of(const Variant& variant) {
    constexpr int kMost = 8;
    const Technique& technique = *find_technique(variant.technique);
    const double power = variant.value_of(*technique.find_parameter("power"));
    int exponent = 0;
    if (std::frexp(power, &exponent) != 0.5 || exponent < 1 || exponent > kMost + 1) return {};
    return exponent - 1;
}

}  // namespace

Recipe view_space_recipe(const Variant& variant, const std::string& shader, int depths_per_sample) {
    Recipe recipe;
    recipe.tables = {rotation_table(variant.noise)};
    // Each sample's depths; the pixel's own depth, normal and rotation.
    recipe.steps = {accessibility_step(
        variant, shader, {Target::kDepth, Target::kPosition, Target::kNormal, "rotations"},
        samples_of_frame(variant) * depths_per_sample + 3)};
    std::vector<std::string>& defines = recipe.steps.front().defines;
    defines.push_back(points_define(part_of(ball_kernel(variant.samples), variant)));
    if (const std::optional<int> squarings = squarings_of(variant)) {
        defines.push_back(fmt::format("p_power {:.1f}", std::ldexp(1.0, *squarings)));
        defines.push_back(fmt::format("SQUARINGS {}", *squarings));
    }
    return recipe;
}

std::map<Ideal, std::string> view_space_nature() {
    return {
        {Ideal::kOpenTilted,
         "the depth at a sample is compared with the depth of P, so the nearer part of a tilted or "
         "round surface counts as an occluder of the rest"},
        {Ideal::kWholeScene,
         "what lies outside the image is not in the buffer and reads as very far"},
    };
}

}  // namespace obscura::renderer
