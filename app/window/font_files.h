// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

namespace obscura::app::window {

/// The characters of UTF-8 texts, without the ends of lines.
[[nodiscard]] std::set<char32_t> characters_of(const std::vector<std::string>& texts);

/// A font of this machine.
struct FontFile {
    std::string path;
    int index = 0;  ///< of the face in the file
};

/// Fonts that draw a text together, and what none of this machine's draws.
struct FontChoice {
    std::vector<FontFile> files;  ///< DejaVu Sans first; empty: there is no outline font at all
    std::set<char32_t> missing;
};
/// By fontconfig; only fonts with outlines of one colour count, which the pages can draw.
[[nodiscard]] FontChoice choose_fonts(const std::set<char32_t>& characters);

}  // namespace obscura::app::window
