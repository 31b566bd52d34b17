// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::stimuli {

/// 8-bit sRGB code values, three a pixel, upper row first.
struct RgbImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// The image as a PNG file's bytes; the same pixels give the same bytes.
[[nodiscard]] std::string encode_png(const RgbImage& image);

/// The pixels of a PNG file's bytes, without any change of colour. Throws bad input naming `name`
/// when it is no 8-bit RGB image.
[[nodiscard]] RgbImage decode_png(std::string_view bytes, const std::string& name);

}  // namespace obscura::stimuli
