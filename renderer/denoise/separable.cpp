// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise separable_denoise() {
    // The slope from the pixel and its two neighbours; six neighbours' depths; seven
    // accessibilities.
    constexpr int kFetches = 3 + 6 + 7;
    Recipe recipe;
    recipe.buffers = {{"denoise step", "r32f"}};
    recipe.steps = {{"denoise",
                     "denoise/separable.glsl",
                     {Target::kAccessibility, Target::kDepth},
                     "denoise step",
                     {"DIRECTION ivec2(1, 0)"},
                     kFetches},
                    {"denoise",
                     "denoise/separable.glsl",
                     {{"denoise step", "accessibility"}, Target::kDepth},
                     Target::kDenoised.name,
                     {"DIRECTION ivec2(0, 1)"},
                     kFetches}};
    return {"separable",
            "bilateral in two passes, as Jakobsen 2010 took from Bavoil and Sainz 2009; weights "
            "follow the slope of the depth",
            recipe, separable_model};
}

}  // namespace obscura::renderer
