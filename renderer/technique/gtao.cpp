// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/gtao.h"

#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    return fan_recipe(variant, "technique/gtao.glsl", fan_of_slices(variant));
}

}  // namespace

Technique gtao_technique() {
    Technique technique;
    technique.name = "gtao";
    technique.variant = "Gtao";
    technique.citation =
        "Jimenez et al. 2016, Practical Realtime Strategies for Accurate Indirect Occlusion; "
        "linear "
        "falloff after Intel's XeGTAO 2021";
    technique.samples = {2, 256, 16, 2, "steps"};
    technique.parameters = {
        slice_radius(),
        slice_steps(),
        slice_reach(1.0),
        {"falloff", "Share of the reach, at its far end, over which an occluder fades to nothing",
         "of the reach", 0.0, 1.0, 0.615},
        {"thin_occluder",
         "How far a horizon sinks towards each lower sample behind it, as for thin occluders", "",
         0.0, 1.0, 0.0},
        slice_spread(1.0),
        slice_power(),
    };
    technique.recipe = recipe_of;
    technique.fitted = {{"reach", 2.876}, {"falloff", 0.961}, {"step_spread", 2.0}, {"power", 2.0}};
    technique.reach = "radius_m";
    technique.model = gtao_model;
    technique.by_nature = slice_nature();
    return technique;
}

}  // namespace obscura::renderer
