// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Jakobsen 2010, Table 4: votes, and what R 4.2.2 gives for them (chisq.test, binom.test,
/// prop.test(correct = FALSE), p.adjust).
struct Table4Row {
    const char* condition;
    Votes votes;
    double chi_square, p, p_exact, wilson_low, wilson_high, cohens_g, p_holm, p_exact_holm;
};
inline constexpr std::array kTable4{
    Table4Row{"I", {18, 18}, 0, 1, 1, .344743, .655257, 0, 1, 1},
    Table4Row{"II", {14, 22}, 1.777778, .182422, .242985, .448645, .752151, .111111, .912112, 1},
    Table4Row{
        "III", {11, 25}, 5.444444, .019631, .028817, .531437, .819955, .194444, .137415, .201717},
    Table4Row{"IV", {16, 20}, .444444, .504985, .617719, .395811, .704587, .055556, 1, 1},
    Table4Row{
        "V", {11, 25}, 5.444444, .019631, .028817, .531437, .819955, .194444, .137415, .201717},
    Table4Row{"VI", {18, 18}, 0, 1, 1, .344743, .655257, 0, 1, 1},
    Table4Row{"VII", {21, 15}, 1, .317311, .405032, .271406, .577997, -.083333, 1, 1},
};

}  // namespace obscura::analysis
