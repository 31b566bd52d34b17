// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise known_error_denoise() {
    constexpr int kTaps = 15;
    Recipe recipe;
    recipe.buffers = {{"denoise surface", "rgba32f"}, {"denoise step", "rgba32f"}};
    recipe.steps = {{"denoise",
                     "denoise/known_error.glsl",
                     {Target::kDepth, Target::kNormal},
                     "denoise surface",
                     {"SURFACE"},
                     2,
                     Cover::kAll},
                    {"denoise",
                     "denoise/known_error.glsl",
                     {Target::kAccessibility, {"denoise surface", "surface"}},
                     "denoise step",
                     {"ACROSS"},
                     2 * kTaps + 2,
                     Cover::kAll},
                    {"denoise",
                     "denoise/known_error.glsl",
                     {{"denoise step", "moments"}, {"denoise surface", "surface"}},
                     Target::kDenoised.name,
                     {},
                     2 * kTaps + 2}};
    return {"known_error",
            "Lee 1980, on surfaces of one plane and normal: the more samples, the less is smoothed",
            recipe, known_error_model};
}

}  // namespace obscura::renderer
