// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise box4_denoise() {
    Recipe recipe;
    recipe.steps = {
        {"denoise", "denoise/box4.glsl", {Target::kAccessibility}, Target::kDenoised.name, {}, 16}};
    return {"box4", "Whinham 2017: mean over the 4x4 tile of rotations", recipe, box4_model,
            "the filter knows no edges"};
}

}  // namespace obscura::renderer
