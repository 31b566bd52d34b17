// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/view_space.h"

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

Recipe view_space_recipe(const Variant& variant, const std::string& shader, int depths_per_sample) {
    Recipe recipe;
    recipe.tables = {rotation_table(), ball_table(variant.samples)};
    // Each sample's depths and point of the ball; the pixel's own depth, normal and rotation.
    recipe.steps = {accessibility_step(variant, shader,
                                       {Target::kDepth, Target::kNormal, "rotations", "kernel"},
                                       variant.samples * (depths_per_sample + 1) + 3)};
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
