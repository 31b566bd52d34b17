// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/report/analysis.h"

namespace obscura::analysis {

/// The share of B that a study should be able to find: Cohen's g = .15, a medium effect (J. Cohen
/// 1988, section 5.2), with this power.
inline constexpr double kShareToFind = 0.65;
inline constexpr double kPowerToHave = 0.80;

/// What the answers say about a hypothesis.
enum class VerdictKind {
    kEvidenceFor,
    kEvidenceAgainst,
    kContradictory,  ///< evidence for it in one place and against it in another
    kNoEvidence,     ///< an effect of kShareToFind would have been found, and none was
    kTooFew,         ///< too few participants to say
    kNothingKnown,   ///< no votes, or nothing to compare
};

struct Verdict {
    std::string hypothesis;  ///< H1, H2, H3
    VerdictKind kind = VerdictKind::kNothingKnown;
    std::string sentence;  ///< with its numbers
};

/// `evidence for`, `no evidence`, `too few participants to say` ...
[[nodiscard]] std::string to_words(VerdictKind kind);

/// One for each hypothesis that conditions name and, where variants were shown at several levels
/// of validity, H3 (unless conditions name an H3 of their own), by verdict_rule().
[[nodiscard]] std::vector<Verdict> verdicts(const Analysis& analysis);

/// The exact p-value of each condition after Holm's correction over all that have one.
[[nodiscard]] std::vector<Possible<double>> exact_p_holm(const Analysis& analysis);

/// The rule in words.
[[nodiscard]] std::string verdict_rule();

/// Power of the chi-square test of homogeneity of two rows of `n` votes each, whose shares of B are
/// `one` and `other`, at `level`: 1 minus the noncentral chi-square distribution at the critical
/// value (J. Cohen 1988, section 7.3). `n` at least 1, shares and level strictly between 0 and 1:
/// throws bad input otherwise.
[[nodiscard]] double power_of_difference(std::int64_t n, double one, double other, double level);

}  // namespace obscura::analysis
