// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise separable_denoise() {
    constexpr int kTaps = 7;
    Recipe recipe;
    Buffer step{"denoise step", "rgba32f"};
    step.columns = 2;
    recipe.buffers = {step};
    recipe.steps = {{"denoise",
                     "denoise/separable.glsl",
                     {Target::kAccessibility, Target::kDepth},
                     "denoise step",
                     {"ACROSS"},
                     2 * (kTaps + 1),
                     Cover::kAll},
                    {"denoise",
                     "denoise/separable.glsl",
                     {{"denoise step", "packed"}},
                     Target::kDenoised.name,
                     {},
                     kTaps,
                     Cover::kAll}};
    recipe.steps.front().depth_beside = true;
    recipe.steps.back().columns = 2;
    return {"separable",
            "bilateral in two passes, as Jakobsen 2010 took from Bavoil and Sainz 2009; weights "
            "follow the slope of the depth",
            recipe, separable_model};
}

}  // namespace obscura::renderer
