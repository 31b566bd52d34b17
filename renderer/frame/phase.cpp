// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/phase.h"

#include <array>

namespace obscura::renderer {

std::string to_string(Phase phase) {
    constexpr std::array kNames{"geometry",      "shadow",  "occluders", "seen",     "second layer",
                                "accessibility", "denoise", "upsample",  "light",    "composite",
                                "forward",       "sky",     "blend",     "tone map", "resolve"};
    return kNames.at(static_cast<std::size_t>(phase));
}

}  // namespace obscura::renderer
