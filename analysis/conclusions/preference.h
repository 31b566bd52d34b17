// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/statistics/bayes_factor.h"
#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/nested_test.h"
#include "analysis/statistics/possible.h"
#include "analysis/statistics/posterior.h"
#include "analysis/statistics/sign_flip.h"
#include "analysis/statistics/wilson.h"
#include "analysis/tally.h"

namespace obscura::analysis {

/// The level below which a p-value is called significant, as in Jakobsen 2010.
inline constexpr double kSignificance = 0.05;
inline constexpr double kConfidence = 0.95;

/// A difference of shares that a study is taken to care about, where it fixes no margin: from one
/// half, or between two levels of validity.
inline constexpr double kRelevantDifference = .15;
/// The smallest share of B, or as far below one half, that a study is taken to care about.
inline constexpr double kRelevantShare = .5 + kRelevantDifference;

/// The confidence of intervals that lie within a margin just where two one-sided tests at
/// kSignificance say so.
inline constexpr double kEqualityConfidence = 1.0 - 2.0 * kSignificance;

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
    ConditionVotes condition;  ///< without its answers, which Analysis::tally has
    Preference preference;
    /// The exact p-value after Holm's correction over all conditions; one without votes counts
    /// as 1.
    Possible<double> p_holm = Possible<double>::none("no votes");
    /// The same after Benjamini and Hochberg's.
    Possible<double> p_bh = Possible<double>::none("no votes");
};

/// What A and B are in every condition of a hypothesis, so that the votes can be added up.
struct Pooling {
    std::string words;         ///< `A is None and B is Blizzard24`
    std::vector<bool> turned;  ///< of each condition: whether what it calls A counts as B
};

/// What an interval of a pooled share rests on.
enum class ShareIntervalKind {
    kMeans,     ///< t over participants
    kEachOnce,  ///< Clopper-Pearson's, each participant counted once: each voted once, nobody
                ///< differs from the others, or few answered
    kCounts     ///< the same with as many people as one condition has votes: who gave them is not
                ///< known
};

/// Participants below which intervals do not rest on how they vary.
inline constexpr std::int64_t kFewestForMeans = 10;

struct ShareInterval {
    Interval bounds;  ///< of the share of B
    ShareIntervalKind kind = ShareIntervalKind::kCounts;
};

/// Whether the conditions of a hypothesis differ: Cochran's Q of those who answered each once.
struct Heterogeneity {
    std::int64_t participants = 0;
    ChiSquareTest test;
};

/// A term of a mixed model.
struct ModelTerm {
    double log_odds = 0.0;
    double standard_error = 0.0;
    Interval interval;  ///< 95 %
    PValue p;           ///< of log odds 0, by Wald's test
};

/// A logistic model with an intercept for each participant, as a check of a verdict's test: its
/// conditions and the order of showing fixed, participants random.
struct ModelCheck {
    std::int64_t participants = 0;
    int nodes = 0;  ///< of the quadrature over participants
    /// Of a hypothesis: the mean over its conditions of the log odds of B, for a participant in the
    /// middle. Of two levels: log odds at the second less those at the first. More levels have no
    /// one effect: conditions_differ is of them.
    Possible<ModelTerm> effect = Possible<ModelTerm>::none("more than two levels");
    Possible<ModelTerm> order = Possible<ModelTerm>::none("not known");  ///< for the second image
    double sd = 0.0;  ///< of the participants, log odds
    /// Likelihood ratio of a term for each condition, or for each of more than two levels.
    Possible<NestedTest> conditions_differ = Possible<NestedTest>::none("one condition");
};

/// What stands beside the p of the verdict's test.
[[nodiscard]] inline Possible<PValue> p_of(const ModelCheck& model) {
    if (model.effect.has_value()) return model.effect->p;
    if (model.conditions_differ.has_value()) return model.conditions_differ->p;
    return Possible<PValue>::none(model.conditions_differ.reason);
}

/// A hypothesis on a preference: the votes of its conditions together.
struct HypothesisResult {
    std::string name;
    std::string statement;  ///< may be empty
    double margin = kRelevantDifference;
    bool is_primary = true;
    std::vector<std::string> conditions;
    std::vector<std::string> secondary;   ///< conditions that name it and are no part of its test
    std::vector<std::string> unanswered;  ///< conditions that it takes and nobody saw
    /// No value, with the reason, where "B" is not the same thing in each condition. There is then
    /// nothing pooled.
    Possible<Pooling> pooling = Possible<Pooling>::none("no conditions");
    /// Chi-square and the exact test take a participant's votes as independent, as was published;
    /// no verdict rests on them.
    Preference pooled;
    /// Of participants instead of votes: those of one participant may hang together.
    Possible<SignFlipTest> by_participant = Possible<SignFlipTest>::none("not known");
    /// Of counts alone: the exact binomial test as if each participant had voted once.
    Possible<PValue> each_once = Possible<PValue>::none("no votes");
    /// Of the share among people, each with a share of his own.
    Possible<Posterior> posterior = Possible<Posterior>::none("no votes");
    Possible<Heterogeneity> heterogeneity = Possible<Heterogeneity>::none("no votes");
    Possible<ModelCheck> model = Possible<ModelCheck>::none("not asked for");
    /// 95 %, the interval to read.
    Possible<ShareInterval> interval = Possible<ShareInterval>::none("no votes");
    /// 90 %: where it lies within the relevant margin, two one-sided tests at .05 say that the
    /// images are practically equal (D. J. Schuirmann 1987).
    Possible<ShareInterval> equality_interval = Possible<ShareInterval>::none("no votes");
    int significant = 0;       ///< conditions with an exact p below the level
    int significant_holm = 0;  ///< those still below it after Holm's correction
    std::string sentence;
};

}  // namespace obscura::analysis
