// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

struct ImFont;

namespace obscura::app::kiosk {

struct Fonts {
    ImFont* text = nullptr;
    ImFont* heading = nullptr;
    ImFont* small = nullptr;
};

/// Adds the system's TrueType fonts to the current Dear ImGui context's atlas, in sizes for a
/// window of that height in pixels, with every character of `texts` (UTF-8) and of the languages
/// written in Latin, Greek and Cyrillic letters. DejaVu Sans comes first; characters it lacks come
/// from another font that fontconfig knows. What no font has is left out (problems_of_text() says
/// it). Throws failure when there is no TrueType font at all.
[[nodiscard]] Fonts load_fonts(const std::vector<std::string>& texts, int window_height);

}  // namespace obscura::app::kiosk
