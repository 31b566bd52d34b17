// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/technique.h"
#include "renderer/technique/view_space.h"

namespace obscura::renderer {

namespace {

constexpr int kSteps = 4;  // along each direction, as in the shader

Recipe recipe_of(const Variant& variant) {
    return view_space_recipe(variant, "technique/raymarch.glsl", kSteps);
}

}  // namespace

Technique raymarch_technique() {
    Technique technique;
    technique.name = "raymarch";
    technique.variant = "RayMarching";
    technique.citation = "Jakobsen 2010, Appendix C, after Bavoil and Sainz 2009 (ShaderX7)";
    technique.samples = {1, 128, 30, 1};
    technique.parameters = view_space_parameters();
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = view_space_model(kSteps);
    technique.by_nature = view_space_nature();
    return technique;
}

}  // namespace obscura::renderer
