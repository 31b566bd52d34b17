// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/technique.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& /*variant*/) {
    constexpr int kTaps = 17;  // as in the shader
    Recipe recipe;
    recipe.buffers = {{"blurred across", "r32f"}, {"blurred depth", "r32f"}};
    recipe.steps = {{"blur of depth",
                     "technique/unsharp_blur.glsl",
                     {Target::kDepth},
                     "blurred across",
                     {"ACROSS"},
                     kTaps,
                     Cover::kAll},
                    {"blur of depth",
                     "technique/unsharp_blur.glsl",
                     {"blurred across"},
                     "blurred depth",
                     {},
                     kTaps,
                     Cover::kAll},
                    {"unsharp mask",
                     "technique/unsharp.glsl",
                     {Target::kColour, Target::kDepth, "blurred depth"},
                     Target::kColour.name,
                     {},
                     3,
                     Cover::kAll}};
    return recipe;
}

}  // namespace

Technique unsharp_technique() {
    Technique technique;
    technique.name = "unsharp";
    technique.variant = "Unsharp";
    technique.citation =
        "Luft et al. 2006, Image Enhancement by Unsharp Masking the Depth Buffer; darkening only, "
        "as in Sunet 2018, 4.8";
    technique.output = Output::kColour;
    technique.parameters = {
        {"radius", "Two standard deviations of the blur", "of the image's height", 0.0, 1.0, 0.03},
        {"strength", "Light taken away for each far plane's depth behind the blurred depth", "",
         0.0, 10000.0, 2.0},
    };
    technique.recipe = recipe_of;
    technique.by_nature[Ideal::kAnyFarPlane] = "it compares depth / far";
    return technique;
}

}  // namespace obscura::renderer
