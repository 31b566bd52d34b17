// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/published_votes.h"

#include <string_view>

#include "analysis/counts_file.h"

namespace obscura::analysis {

/// Made by obscura_embed.
std::string_view embedded(std::string_view name);

Tally published_votes() { return parse_counts(embedded("data/jakobsen2010.csv"), "jakobsen2010"); }

}  // namespace obscura::analysis
