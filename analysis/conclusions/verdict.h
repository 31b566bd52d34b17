// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/conclusions/preference.h"

namespace obscura::analysis {

/// What the answers say about a hypothesis.
enum class Conclusion { kUndecided, kBPreferred, kAPreferred, kEqual, kDiffers, kSame, kNotTested };

/// `undecided`, `B preferred over A`, `A preferred over B`, `practically equal (within 15 points)`;
/// on validity `the effect differs with lighting`, `equal within 15 points`; `not tested`.
[[nodiscard]] std::string to_string(Conclusion conclusion, double margin);

/// One test of a verdict on validity.
struct ComparedVerdict {
    std::vector<std::string> conditions;
    Possible<PValue> p = Possible<PValue>::none("no votes");
    Possible<double> p_holm = Possible<double>::none("no votes");
    /// 95 %, of the difference between its levels that may be largest.
    Possible<Interval> interval = Possible<Interval>::none("no votes");
};

struct Verdict {
    std::string hypothesis;
    std::string statement;  ///< may be empty
    bool is_on_validity = false;
    bool is_primary = true;               ///< secondary: p alone decides, and nothing is corrected
    double margin = kRelevantDifference;  ///< the smallest effect that matters
    Conclusion conclusion = Conclusion::kNotTested;
    /// There is a preference, or the effect differs, and by less than a study is taken to care
    /// about.
    bool is_small = false;
    std::string direction;  ///< where the effect differs: `B more often at high than at moderate`
    /// Of the test that the verdict rests on; of validity, of the comparison with the smallest.
    Possible<PValue> p = Possible<PValue>::none("no votes");
    /// After Holm's correction over the tests of all primary hypotheses.
    Possible<double> p_holm = Possible<double>::none("no votes");
    std::size_t tests = 0;  ///< that were corrected together
    /// 95 %, of the share of B; of validity, of the difference that may be largest.
    Possible<Interval> interval = Possible<Interval>::none("no votes");
    Possible<Interval> equality = Possible<Interval>::none("no votes");  ///< 90 %, of the same
    std::vector<ComparedVerdict> compared;  ///< of validity: every comparison
    std::string sentence;                   ///< with the conclusion and its numbers
};

/// The conclusion with its direction and whether it is small: `B preferred over A by less than the
/// relevant 15 points`.
[[nodiscard]] std::string verdict_words(const Verdict& verdict);

/// How verdicts are reached, in words.
[[nodiscard]] std::string verdict_rule();

}  // namespace obscura::analysis
