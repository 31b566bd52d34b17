// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

const std::vector<Denoise>& denoise_filters() {
    static const std::vector<Denoise> list = {
        {"none", "no filter", "", 0, false, 0, {}, ""},
        {"box4", "Whinham 2017: mean over the 4x4 tile of rotations", "denoise/box4.glsl", 1, false,
         16, box4_model, "the filter knows no edges"},
        {"separable",
         "bilateral in two passes, as Jakobsen 2010 took from Bavoil and Sainz 2009; weights "
         "follow the slope of the depth",
         "denoise/separable.glsl", 2, true, 2 * (3 + 6 + 7), separable_model, ""},
    };
    return list;
}

const Denoise* find_denoise(std::string_view name) {
    for (const Denoise& denoise : denoise_filters()) {
        if (denoise.name == name) return &denoise;
    }
    return nullptr;
}

}  // namespace obscura::renderer
