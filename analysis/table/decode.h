// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::analysis {

struct DecodedText {
    std::string text;      ///< UTF-8 without a byte order mark
    std::string encoding;  ///< what it was taken for; empty: it was UTF-8
};

/// The text of a file in the encodings that spreadsheets write: UTF-8, UTF-16 and UTF-32 (by their
/// byte order mark; UTF-16 also without one), else Windows-1252, which Latin-1 is a part of. Throws
/// bad input as `name:line: what it is not, and what to do` for bytes that are none of these, and
/// for a NUL.
[[nodiscard]] DecodedText decode(std::string bytes, const std::string& name);

}  // namespace obscura::analysis
