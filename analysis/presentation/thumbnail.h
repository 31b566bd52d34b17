// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace obscura::analysis {

/// The media type of a thumbnail.
inline constexpr const char* kThumbnailType = "image/jpeg";

/// The bytes of an 8-bit sRGB PNG file made smaller, to `width_px` (at least 1) or its own width
/// where that is less, as a JPEG file's bytes. Pixels are averaged as light, in linear values, so
/// that a small image is as bright as the large one. The same bytes give the same thumbnail. Throws
/// bad input naming `name` when the bytes are no such image.
[[nodiscard]] std::string thumbnail(std::string_view image_file, const std::string& name,
                                    int width_px);

}  // namespace obscura::analysis
