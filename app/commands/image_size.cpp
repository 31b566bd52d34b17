// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/image_size.h"

#include <charconv>

#include "renderer/base/check.h"
#include "renderer/base/error.h"

namespace obscura::app {

namespace {

constexpr int kMostPixels = 16384;

}  // namespace

ImageSize parse_size(const std::string& text) {
    ImageSize size;
    const char* const end = text.data() + text.size();
    const auto [cross, first] = std::from_chars(text.data(), end, size.width);
    if (first == std::errc() && cross != end && *cross == 'x') {
        const auto [rest, second] = std::from_chars(cross + 1, end, size.height);
        if (second == std::errc() && rest == end) {
            base::check_range("--size", "width", size.width, 1, kMostPixels);
            base::check_range("--size", "height", size.height, 1, kMostPixels);
            return size;
        }
    }
    throw base::bad_input("--size: \"{}\" is not WxH in pixels, such as 1280x720", text);
}

}  // namespace obscura::app
