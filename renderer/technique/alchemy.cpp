// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/disc.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    Recipe recipe = disc_recipe(variant, "technique/alchemy.glsl", 1);
    Step& step = recipe.steps.front();
    step.reads.emplace_back(Target::kPosition);
    // Of every sample too.
    if (variant.position == "stored") step.fetches += samples_of_frame(variant);
    return recipe;
}

}  // namespace

Technique alchemy_technique() {
    Technique technique;
    technique.name = "alchemy";
    technique.variant = "Alchemy";
    technique.citation =
        "McGuire et al. 2011, The Alchemy Screen-Space Ambient Obscurance Algorithm; as in Sunet "
        "2018 and Hussain 2021";
    technique.samples = {1, 128, 16, 1};
    technique.parameters = {
        slice_radius(),
        slice_reach(1.0),
        {"strength", "Intensity of the obscurance", "radius_m", 0.0, 100.0, 1.0},
        {"bias", "Height above the tangent plane that does not occlude", "of the depth", 0.0, 1.0,
         0.001},
        {"epsilon", "Added to the square of a distance", "of radius_m squared", 0.0, 10.0, 0.01},
        {"power", "Exponent of the accessibility", "", 0.0, 10000.0, 1.0},
    };
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = alchemy_model;
    technique.by_nature = slice_nature();
    technique.by_nature[Ideal::kOpenFacing] =
        "an occluder's effect falls with its distance but ends nowhere: what is nearer to the "
        "camera by more than the radius still occludes";
    technique.by_nature[Ideal::kOpenTilted] =
        "it divides by the square of a distance, so the 8 bits of a normal count as height where "
        "the radius is large against the bias";
    return technique;
}

}  // namespace obscura::renderer
