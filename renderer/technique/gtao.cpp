// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/gtao.h"

#include <fmt/format.h>

#include <numbers>

#include "renderer/technique/sampling.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    const int slices = variant.samples / (2 * kSliceSteps);
    const double sector_rad = std::numbers::pi / slices;
    Recipe recipe;
    recipe.tables = {turn_table(sector_rad)};
    // Each sample's depth; the pixel's own depth, normal and turn.
    Step step = accessibility_step(variant, "technique/gtao.glsl",
                                   {Target::kDepth, Target::kNormal, "turns"}, variant.samples + 3);
    step.defines.push_back(fmt::format("SLICES {}", slices));
    step.defines.push_back(direction_define("SLICE_TURNS", slices, sector_rad));
    recipe.steps = {step};
    return recipe;
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
    technique.samples = {2 * kSliceSteps, 128, 2 * 2 * kSliceSteps, 2 * kSliceSteps};
    technique.parameters = {
        slice_radius(),
        slice_reach(1.0),
        {"falloff", "Share of the reach, at its far end, over which an occluder fades to nothing",
         "of the reach", 0.0, 1.0, 0.615},
        {"thin_occluder",
         "How far a horizon sinks towards each lower sample behind it, as for thin occluders", "",
         0.0, 1.0, 0.0},
        {"step_spread", "How samples lie along a slice: 0 evenly, 1 by the square of their number",
         "", 0.0, 1.0, 1.0},
        {"power", "Exponent of the accessibility", "", 0.0, 10000.0, 1.0},
    };
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = gtao_model;
    technique.by_nature = slice_nature();
    return technique;
}

}  // namespace obscura::renderer
