// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "analysis/presentation/html.h"

namespace obscura::analysis {

/// Plain text for LaTeX (UTF-8): its special characters made safe, a citation `[@key; @other]`
/// (Pandoc's) as `\cite{key,other}`.
[[nodiscard]] std::string latex_text(std::string_view text);

/// A floating table in the manner of the package booktabs, the caption above.
[[nodiscard]] std::string latex_table(const PageTable& table, std::string_view caption,
                                      std::string_view label);

/// The entries of references.bib that the text cites, in their order there.
[[nodiscard]] std::string cited_entries(std::string_view text);

}  // namespace obscura::analysis
