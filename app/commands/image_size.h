// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::app {

/// Of an image in pixels.
struct ImageSize {
    int width = 0;
    int height = 0;
};

/// The value of --size, `1280x720`. Throws bad input for anything but two whole numbers from 1 to
/// 16384.
[[nodiscard]] ImageSize parse_size(const std::string& text);

}  // namespace obscura::app
