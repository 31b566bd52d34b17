// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/hbao.h"

#include <fmt/format.h>

#include <numbers>

#include "renderer/technique/sampling.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    const int directions = variant.samples / kSliceSteps;
    const double sector_rad = 2.0 * std::numbers::pi / directions;
    Recipe recipe;
    recipe.tables = {turn_table(sector_rad)};
    // Each sample's depth; the pixel's own depth, normal and turn.
    Step step = accessibility_step(variant, "technique/hbao.glsl",
                                   {Target::kDepth, Target::kNormal, "turns"}, variant.samples + 3);
    step.defines.push_back(fmt::format("DIRECTIONS {}", directions));
    step.defines.push_back(direction_define("DIRECTION_TURNS", directions, sector_rad));
    recipe.steps = {step};
    return recipe;
}

}  // namespace

Technique hbao_technique() {
    Technique technique;
    technique.name = "hbao";
    technique.variant = "Hbao";
    technique.citation =
        "Bavoil and Sainz 2008, Image-Space Horizon-Based Ambient Occlusion; as in Sunet 2018 and "
        "Hussain 2021";
    technique.samples = {kSliceSteps, 128, 4 * kSliceSteps, kSliceSteps};
    technique.parameters = {
        slice_radius(),
        slice_reach(1.0),
        {"bias", "Sine of the angle above the tangent plane below which nothing occludes", "", 0.0,
         0.99, 0.5},
        {"step_spread", "How samples lie along a slice: 0 evenly, 1 by the square of their number",
         "", 0.0, 1.0, 0.0},
        {"strength", "Factor of the occlusion", "", 0.0, 10.0, 1.0},
        {"power", "Exponent of the accessibility", "", 0.0, 10000.0, 1.0},
    };
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = hbao_model;
    technique.by_nature = slice_nature();
    return technique;
}

}  // namespace obscura::renderer
