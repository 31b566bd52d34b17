// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise gaussian_nd_denoise() {
    constexpr int kTaps = 13;
    Recipe recipe;
    recipe.buffers = {{"denoise step", "rg32f"}};
    recipe.steps = {{"denoise",
                     "denoise/gaussian_nd.glsl",
                     {Target::kAccessibility, Target::kDepth, Target::kNormal},
                     "denoise step",
                     {"ACROSS"},
                     3 * kTaps + 4,
                     Cover::kAll},
                    {"denoise",
                     "denoise/gaussian_nd.glsl",
                     {{"denoise step", "packed"}, Target::kNormal},
                     Target::kDenoised.name,
                     {},
                     2 * kTaps + 2}};
    return {"gaussian_nd",
            "Filion and McNaughton 2008: a Gaussian in two passes that stops where depth or normal "
            "differ",
            recipe, gaussian_nd_model};
}

}  // namespace obscura::renderer
