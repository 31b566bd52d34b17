// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "analysis/presentation/html.h"

namespace obscura::analysis {

/// The table as an HTML element, numbers with their decimal points below each other.
[[nodiscard]] std::string html_table(const PageTable& table, std::string_view caption);

/// The table as Markdown (GitHub's), the caption in italics below it.
[[nodiscard]] std::string markdown_table(const PageTable& table, std::string_view caption);

/// Plain text with what Markdown would take for a mark made safe.
[[nodiscard]] std::string markdown_escaped(std::string_view text);

}  // namespace obscura::analysis
