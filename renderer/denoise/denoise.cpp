// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

const Denoise* find_denoise(std::string_view name) {
    for (const Denoise& denoise : denoise_filters()) {
        if (denoise.name == name) return &denoise;
    }
    return nullptr;
}

}  // namespace obscura::renderer
