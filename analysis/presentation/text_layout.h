// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace obscura::analysis {

using TextRow = std::vector<std::string>;

/// Stands for a value that there is none of, in plain text.
inline constexpr const char* kNoText = "-";

/// Columns two blanks apart, as wide as their widest cell in letters (UTF-8); the first `left` are
/// set to the left, the others to the right. `rows` has at least one row; all have as many cells.
[[nodiscard]] std::string aligned(const std::vector<TextRow>& rows, std::size_t left);

/// Lines of at most 100 letters, broken at blanks and continued two blanks further in.
[[nodiscard]] std::string wrapped(const std::string& text);

}  // namespace obscura::analysis
