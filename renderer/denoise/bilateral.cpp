// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise bilateral_denoise() {
    constexpr int kTaps = 7 * 7;
    Recipe recipe;
    recipe.steps = {{"denoise",
                     "denoise/bilateral.glsl",
                     {Target::kAccessibility, Target::kDepth},
                     Target::kDenoised.name,
                     {},
                     2 * kTaps + 4}};
    return {"bilateral",
            "Tomasi and Manduchi 1998 over its full window, as in Sunet 2018; weights follow the "
            "slope of the depth",
            recipe, bilateral_model};
}

}  // namespace obscura::renderer
