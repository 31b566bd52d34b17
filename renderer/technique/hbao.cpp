// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/hbao.h"

#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    return fan_recipe(variant, "technique/hbao.glsl", fan_of_directions(variant));
}

}  // namespace

Technique hbao_technique() {
    Technique technique;
    technique.name = "hbao";
    technique.variant = "Hbao";
    technique.citation =
        "Bavoil and Sainz 2008, Image-Space Horizon-Based Ambient Occlusion; as in Sunet 2018 and "
        "Hussain 2021";
    technique.samples = {1, 256, 16, 1, "steps"};
    technique.parameters = {
        slice_radius(),
        slice_steps(),
        slice_reach(1.0),
        {"bias", "Sine of the angle above the tangent plane below which nothing occludes", "", 0.0,
         0.99, 0.5},
        slice_spread(0.0),
        {"strength", "Factor of the occlusion", "", 0.0, 10.0, 1.0},
        slice_power(),
    };
    technique.recipe = recipe_of;
    technique.fitted = {
        {"reach", 1.8}, {"bias", 0.102}, {"step_spread", 1.6}, {"strength", 0.73}, {"power", 2.0}};
    technique.reach = "radius_m";
    technique.model = hbao_model;
    technique.by_nature = slice_nature();
    return technique;
}

}  // namespace obscura::renderer
