// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

struct ImFont;

namespace obscura::app::window {

struct Fonts {
    ImFont* text = nullptr;
    ImFont* heading = nullptr;
    ImFont* small = nullptr;
};

/// Heights in pixels.
struct FontSizes {
    float text_px = 0.0F;
    float heading_px = 0.0F;
    float small_px = 0.0F;
};

/// For pages that fill a window of that height in pixels.
[[nodiscard]] FontSizes sizes_of_pages(int window_height);

/// Adds the system's TrueType fonts to the current Dear ImGui context's atlas, in those
/// sizes, with every character of `texts` (UTF-8) and of the languages
/// written in Latin, Greek and Cyrillic letters. DejaVu Sans comes first; characters it lacks come
/// from another font that fontconfig knows. What no font has is left out (problems_of_text() says
/// it). Throws failure when there is no TrueType font at all.
[[nodiscard]] Fonts load_fonts(const std::vector<std::string>& texts, const FontSizes& sizes);

}  // namespace obscura::app::window
