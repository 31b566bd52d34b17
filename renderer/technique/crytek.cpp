// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/sampling.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {

namespace {

Recipe recipe_of(const Variant& variant) {
    Recipe recipe;
    recipe.tables = {rotation_table()};
    // Each sample's depth; the pixel's own depth and rotation.
    recipe.steps = {accessibility_step(variant, "technique/crytek.glsl",
                                       {Target::kDepth, "rotations"}, variant.samples + 2)};
    return recipe;
}

}  // namespace

Technique crytek_technique() {
    Technique technique;
    technique.name = "crytek";
    technique.variant = "Crytek";
    technique.citation = "Jakobsen 2010, Appendix A, after Kajalin 2009 (ShaderX7)";
    technique.samples = {8, 128, 24, 8};
    technique.parameters = {
        {"offset_scale",
         "Length of the offsets before the first sample; each sample multiplies it by 1 + 2.4/N",
         "fraction of the image, and of the depth", 0.0, 1.0, 0.01},
    };
    technique.recipe = recipe_of;
    return technique;
}

}  // namespace obscura::renderer
