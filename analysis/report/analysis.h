// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/bayes_factor.h"
#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/mcnemar.h"
#include "analysis/statistics/order_bias.h"
#include "analysis/statistics/paired_scale.h"
#include "analysis/statistics/possible.h"
#include "analysis/statistics/posterior.h"
#include "analysis/statistics/wilson.h"
#include "analysis/tally.h"

namespace obscura::analysis {

/// The level below which a p-value is called significant, as in Jakobsen 2010.
inline constexpr double kSignificance = 0.05;
inline constexpr double kConfidence = 0.95;

/// Is one of two images preferred? Every test of one set of votes.
struct Preference {
    Votes votes;
    Possible<double> share_b = Possible<double>::none("no votes");
    Possible<ChiSquareTest> chi_square = Possible<ChiSquareTest>::none("no votes");
    Possible<PValue> exact = Possible<PValue>::none("no votes");
    Possible<Interval> wilson = Possible<Interval>::none("no votes");
    Possible<Interval> clopper_pearson = Possible<Interval>::none("no votes");
    Possible<double> cohens_g = Possible<double>::none("no votes");
    Possible<Posterior> posterior = Possible<Posterior>::none("no votes");  ///< of the share of B
    Possible<BayesFactor> bayes_factor = Possible<BayesFactor>::none("no votes");
};

struct ConditionResult {
    ConditionVotes condition;
    Preference preference;
    /// The chi-square p-value after Holm's correction over all conditions that have one.
    Possible<double> p_holm = Possible<double>::none("no votes");
    /// The same after Benjamini and Hochberg's.
    Possible<double> p_bh = Possible<double>::none("no votes");
};

/// A hypothesis that conditions name: their votes together.
struct HypothesisResult {
    std::string name;
    std::vector<std::string> conditions;
    Preference pooled;
    int significant = 0;       ///< conditions with p below the level
    int significant_holm = 0;  ///< those still below it after Holm's correction
    std::string sentence;
};

/// The same question asked of the participants who answered every condition compared.
struct SameParticipants {
    std::int64_t n = 0;           ///< participants who answered all of the conditions
    std::int64_t incomplete = 0;  ///< participants who answered only some, left out
    Possible<ChiSquareTest> cochran_q = Possible<ChiSquareTest>::none("no participants");
    /// Of two conditions; `changed` went from B to A (a) and from A to B (b).
    Possible<McNemarTest> mcnemar = Possible<McNemarTest>::none("not two conditions");
    Votes changed;
};

/// Does the share of B differ between conditions that show the same two variants?
struct Comparison {
    std::string variant_a;
    std::string variant_b;
    std::vector<std::string> conditions;
    std::vector<std::string> levels;  ///< validity of each row of votes
    std::vector<Votes> votes;         ///< one row a level, or a condition
    /// From the counts alone, as if different people had voted in each row.
    Possible<ChiSquareTest> test = Possible<ChiSquareTest>::none("no votes");
    /// The same of two rows, exactly.
    Possible<PValue> fisher = Possible<PValue>::none("not two rows");
    /// The test to read where there is one.
    Possible<SameParticipants> same_participants = Possible<SameParticipants>::none("not known");
};

/// The p-value to read: Cochran's Q over more than two rows and McNemar's test over two where the
/// answers of each participant are known, the test of counts otherwise.
[[nodiscard]] Possible<PValue> p_of(const Comparison& comparison);

/// That test in words, with its numbers and who it is about; where there is none, why.
[[nodiscard]] std::string test_words(const Comparison& comparison);

/// H3: the effect depends on ecological validity.
struct ValidityResult {
    /// For each pair of variants shown at two levels or more: the votes of a level together.
    std::vector<Comparison> by_level;
    /// Every two conditions with the same variants and different levels.
    std::vector<Comparison> by_pair;
    std::string sentence;
};

struct OrderBias {
    OrderVotes votes;
    Possible<PValue> exact = Possible<PValue>::none("no votes");
    /// With a term for each condition, so that unbalanced orders do no harm.
    Possible<OrderBiasTest> logistic = Possible<OrderBiasTest>::none("not counted");
};

/// The variants that the study's pairs connect, on one scale.
struct VariantScale {
    std::vector<std::string> variants;                                  ///< the reference first
    Possible<Scale> bradley_terry = Possible<Scale>::none("no votes");  ///< in log odds
    Possible<Scale> thurstone = Possible<Scale>::none("no votes");      ///< in JOD
};

/// The answers to the study's questions.
struct Analysis {
    Tally tally;
    std::vector<ConditionResult> conditions;
    std::string sentence;                      ///< what the conditions say, before and after Holm
    std::vector<HypothesisResult> hypotheses;  ///< in order of their names
    ValidityResult validity;
    Possible<OrderBias> order_bias = Possible<OrderBias>::none("not counted");
    std::vector<VariantScale> scales;  ///< one for each group that pairs connect, with votes
};

[[nodiscard]] Analysis analyse(const Tally& tally);

/// A table for people, with what was tested in words. Ends with a line feed.
[[nodiscard]] std::string text_report(const Analysis& analysis);

/// JSON with numbers in full precision; a value that does not exist is null, and beside NAME stands
/// NAME_reason. Ends with a line feed.
[[nodiscard]] std::string json_report(const Analysis& analysis);

/// A p-value for people: six decimals, four significant digits below a thousandth, and a power of
/// ten where a double is too small.
[[nodiscard]] std::string p_text(const PValue& p);

}  // namespace obscura::analysis
