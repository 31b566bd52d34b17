// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::renderer {

/// 32-bit float channels of one size, each upper row first, with attributes.
struct FloatImage {
    struct Channel {
        std::string name;           ///< `ao.Y`, `Z`
        std::vector<float> values;  ///< width * height
    };
    int width = 0;
    int height = 0;
    std::vector<Channel> channels;
    std::map<std::string, std::string> texts;
    std::map<std::string, std::array<float, 16>> matrices;  ///< column-major

    /// The values of that channel, or nullptr.
    [[nodiscard]] const std::vector<float>* find(std::string_view channel) const;
};

/// The image as an OpenEXR file's bytes, losslessly compressed. Throws failure when it cannot be
/// encoded.
[[nodiscard]] std::string encode_exr(const FloatImage& image);

/// The channels, texts and matrices of an OpenEXR file's bytes. Throws bad input naming `name` when
/// they are none.
[[nodiscard]] FloatImage decode_exr(std::string_view bytes, const std::string& name);

}  // namespace obscura::renderer
