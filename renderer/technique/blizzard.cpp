// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/technique.h"
#include "renderer/technique/view_space.h"

namespace obscura::renderer {

namespace {

Recipe recipe_of(const Variant& variant) {
    return view_space_recipe(variant, "technique/blizzard.glsl", 1);
}

}  // namespace

Technique blizzard_technique() {
    Technique technique;
    technique.name = "blizzard";
    technique.variant = "Blizzard";
    technique.citation = "Jakobsen 2010, Appendix B, after Filion and McNaughton 2008";
    technique.samples = {1, 128, 24, 1};
    technique.parameters = view_space_parameters();
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = view_space_model(1);
    technique.by_nature = view_space_nature();
    return technique;
}

}  // namespace obscura::renderer
