// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/disc.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    return disc_recipe(variant, "technique/homebrewed.glsl", 2);
}

}  // namespace

Technique homebrewed_technique() {
    const std::string edges =
        "it compares normals, so a convex edge and an object far before another count as a corner";
    Technique technique;
    technique.name = "homebrewed";
    technique.variant = "Homebrewed";
    technique.citation = "Sunet 2018, 4.9";
    technique.samples = {1, 128, 8, 1};
    technique.parameters = {
        slice_radius(),
        slice_reach(1.0),
        {"strength", "Factor of the occlusion", "", 0.0, 10.0, 1.0},
    };
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = homebrewed_model;
    technique.by_nature = slice_nature();
    technique.by_nature[Ideal::kOpenFacing] = edges;
    technique.by_nature[Ideal::kOpenTilted] = edges;
    technique.by_nature[Ideal::kAnyFarPlane] = "it weighs occluders by depth / far";
    return technique;
}

}  // namespace obscura::renderer
