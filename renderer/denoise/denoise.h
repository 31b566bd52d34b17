// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obscura::renderer {

/// One way to smooth the accessibility buffer.
struct Denoise {
    std::string name;  ///< in files and on the command line
    std::string citation;
    std::string shader;  ///< file in renderer/denoise/; empty: no pass
    int passes = 0;
    bool reads_depth = false;
    int fetches = 0;  ///< texture reads of one pixel, over all passes, at most
};

/// All denoise filters.
[[nodiscard]] const std::vector<Denoise>& denoise_filters();

/// The filter of that name, or nullptr.
[[nodiscard]] const Denoise* find_denoise(std::string_view name);

}  // namespace obscura::renderer
