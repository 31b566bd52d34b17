// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/conclusions/preference.h"
#include "analysis/statistics/mcnemar.h"

namespace obscura::analysis {

/// The same question asked of the participants who answered every condition compared.
struct SameParticipants {
    std::int64_t n = 0;           ///< participants who answered all of the conditions
    std::int64_t incomplete = 0;  ///< participants who answered only some, left out
    Possible<ChiSquareTest> cochran_q = Possible<ChiSquareTest>::none("no participants");
    /// Of two conditions; `changed` went from B to A (a) and from A to B (b).
    Possible<McNemarTest> mcnemar = Possible<McNemarTest>::none("not two conditions");
    Votes changed;
};

/// What an interval of a difference rests on.
enum class DifferenceKind {
    kPaired,    ///< the participants who answered both once, with exact limits of their changes
    kContrast,  ///< t of the same participants' own differences over several pairs of conditions
    kCounts     ///< Newcombe's, as if different people had answered
};

/// `same participants`, `t of the same participants' differences`, `counts`.
[[nodiscard]] std::string_view to_string(DifferenceKind kind);

/// By how much the share of B differs between two levels.
struct LevelDifference {
    std::size_t from = 0;  ///< place in Comparison::levels
    std::size_t to = 0;
    double difference = 0.0;  ///< share at `to` less share at `from`, -1 to 1
    Interval interval;        ///< 95 %
    Interval equality;        ///< 90 %, for two one-sided tests at .05
    DifferenceKind kind = DifferenceKind::kCounts;
};

/// By how much each participant's share of B differs between two levels, where several conditions
/// show the two variants: his mean difference over the scenes that show both levels.
struct LevelContrast {
    std::int64_t n = 0;         ///< participants
    std::int64_t left_out = 0;  ///< who answered some of the conditions and are not among them
    std::size_t scenes = 0;
    /// By flipping the signs of the participants' differences, exact where each of them answered
    /// every condition once; p is 1 where nobody's share differs.
    PValue p;
    bool is_exact = true;
    double difference = 0.0;  ///< share at the second level less that at the first
    Interval interval;        ///< 95 %, by t; exact limits where all participants differ alike
    Interval equality;        ///< 90 %
};

/// Does the share of B differ between conditions that show the same two variants?
struct Comparison {
    std::string variant_a;
    std::string variant_b;
    std::string view;  ///< what the conditions show, whatever the light; empty: not the same
    std::vector<std::string> conditions;
    std::vector<bool> turned;         ///< of each condition: whether it calls variant_b A
    std::vector<std::string> levels;  ///< validity of each row of votes
    std::vector<Votes> votes;         ///< one row a level, or a condition
    /// From the counts alone, as if different people had voted in each row.
    Possible<ChiSquareTest> test = Possible<ChiSquareTest>::none("no votes");
    /// The same of two rows, exactly.
    Possible<PValue> fisher = Possible<PValue>::none("not two rows");
    /// The test to read where there is one.
    Possible<SameParticipants> same_participants = Possible<SameParticipants>::none("not known");
    /// Of several conditions at a level: the test to read where there is one.
    Possible<LevelContrast> contrast = Possible<LevelContrast>::none("one condition at each level");
    std::vector<LevelDifference> differences;  ///< of every two levels with votes
    Possible<ModelCheck> model = Possible<ModelCheck>::none("not asked for");
};

/// The p-value to read. Where the answers of each participant are known: over two levels McNemar's
/// exact test, or of several conditions at a level the test by flipping the signs of the
/// participants' differences; Cochran's Q over more levels. Otherwise Fisher's exact test of two
/// rows of counts, chi-square of more. It is 1 where every participant answered alike at every
/// level.
[[nodiscard]] Possible<PValue> p_of(const Comparison& comparison);

/// That test in words, with its numbers and who it is about; where there is none, why.
[[nodiscard]] std::string test_words(const Comparison& comparison);

/// Does the preference depend on ecological validity? Like is compared with like: the same two
/// variants, seen in the same scene by the same camera at two levels or more.
struct ValidityResult {
    std::string name;       ///< of the question: the hypothesis's, else kValidityQuestion
    std::string statement;  ///< may be empty
    double margin = kRelevantDifference;
    bool is_primary = true;
    std::size_t planned = 0;  ///< comparisons that the study fixed; 0: it fixed none
    /// One for each pair that the study fixed; where it fixed none, one for each two variants where
    /// one scene shows them, once at each level; else one for every two levels, over the scenes
    /// that show both.
    std::vector<Comparison> by_level;
    /// Of each comparison over more than two conditions, every two of a scene, up to
    /// kMostPairedConditions conditions.
    std::vector<Comparison> by_pair;
    std::vector<std::string> without_partner;  ///< conditions that have none to be compared with
    std::string no_comparison;                 ///< why by_level is empty; empty where it is not
    /// Over different scenes, as the thesis compared its conditions: published votes only, no test
    /// of validity and part of no verdict.
    std::vector<Comparison> across_scenes;
    std::string sentence;
};

/// What the question is called in a study that has no name of its own for it.
inline constexpr const char* kValidityQuestion = "validity";

/// Conditions with the same variants beyond which they are not compared two by two.
inline constexpr std::size_t kMostPairedConditions = 20;

}  // namespace obscura::analysis
