// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/bitmask.h"

#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    return fan_recipe(variant, "technique/bitmask.glsl", fan_of_slices(variant));
}

}  // namespace

std::vector<Parameter> bitmask_parameters() {
    return {
        slice_radius(),
        slice_steps(),
        slice_reach(1.0),
        {"cut_off", "Distance beyond which a sample occludes nothing", "of radius_m", 0.0, 20.0,
         1.0},
        {"thickness", "Thickness of every occluder, along the ray from the camera", "of radius_m",
         0.0, 20.0, 0.5},
        slice_spread(1.0),
        slice_power(),
    };
}

Technique bitmask_technique() {
    Technique technique;
    technique.name = "bitmask";
    technique.variant = "Bitmask";
    technique.citation =
        "Therrien et al. 2023, Screen Space Indirect Lighting with Visibility Bitmask; cosine "
        "weights after Jimenez et al. 2016";
    technique.samples = {2, 256, 16, 2, "steps"};
    technique.parameters = bitmask_parameters();
    technique.recipe = recipe_of;
    technique.fitted = {{"reach", 1.2},
                        {"cut_off", 2.15},
                        {"thickness", 0.748},
                        {"step_spread", 2.0},
                        {"power", 1.35}};
    technique.reach = "radius_m";
    technique.model = bitmask_model;
    technique.by_nature = slice_nature();
    return technique;
}

}  // namespace obscura::renderer
