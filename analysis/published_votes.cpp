// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/published_votes.h"

#include "analysis/counts_file.h"
#include "analysis/text/embedded.h"

namespace obscura::analysis {

Tally published_votes() {
    return parse_counts(std::string(embedded("data/jakobsen2010.csv")), "jakobsen2010");
}

}  // namespace obscura::analysis
