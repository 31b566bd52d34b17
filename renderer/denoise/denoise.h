// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/recipe/recipe.h"

namespace obscura::renderer {

/// One way to smooth the accessibility buffer. Its recipe reads `accessibility` and writes
/// `denoised`; without steps nothing is smoothed.
struct Denoise {
    std::string name;  ///< in files and on the command line
    std::string citation;
    Recipe recipe;
};

/// All denoise filters.
[[nodiscard]] const std::vector<Denoise>& denoise_filters();

/// The filter of that name, or nullptr.
[[nodiscard]] const Denoise* find_denoise(std::string_view name);

}  // namespace obscura::renderer
