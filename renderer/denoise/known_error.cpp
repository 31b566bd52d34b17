// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise known_error_denoise() {
    constexpr int kTaps = 15;
    Recipe recipe;
    recipe.buffers = {{"denoise step", "rgba32f"}};
    recipe.steps = {{"denoise",
                     "denoise/known_error.glsl",
                     {Target::kAccessibility, Target::kDepth, Target::kNormal},
                     "denoise step",
                     {"ACROSS"},
                     3 * kTaps + 6,
                     Cover::kAll},
                    {"denoise",
                     "denoise/known_error.glsl",
                     {{"denoise step", "packed"}, Target::kNormal},
                     Target::kDenoised.name,
                     {},
                     2 * kTaps + 3}};
    return {"known_error",
            "Lee 1980, on surfaces of one plane and normal: the more samples, the less is smoothed",
            recipe, known_error_model};
}

}  // namespace obscura::renderer
