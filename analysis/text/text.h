// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obscura::analysis {

/// Whether the bytes are well-formed UTF-8 (RFC 3629).
[[nodiscard]] bool is_utf8(std::string_view text);

/// The text as a message may show it: control characters as \n, \t or \x1b, what is no UTF-8 byte
/// by byte as \xff, and no more than `most` bytes, with ... behind them.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = 60);

/// The shortest decimal text that reads back as the same double; `inf` and `nan` have none and are
/// a programming error.
[[nodiscard]] std::string shortest(double value);

/// The same, at the end of `text`.
void append_shortest(std::string& text, double value);

/// Text with & < > " made safe for HTML.
[[nodiscard]] std::string html_escaped(std::string_view text);

}  // namespace obscura::analysis
