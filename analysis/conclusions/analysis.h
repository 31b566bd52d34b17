// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/conclusions/family.h"
#include "analysis/conclusions/looks.h"
#include "analysis/registration.h"
#include "analysis/statistics/bayes_factor.h"
#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/mcnemar.h"
#include "analysis/statistics/order_bias.h"
#include "analysis/statistics/paired_scale.h"
#include "analysis/statistics/possible.h"
#include "analysis/statistics/posterior.h"
#include "analysis/statistics/power.h"
#include "analysis/statistics/quartiles.h"
#include "analysis/statistics/sign_flip.h"
#include "analysis/statistics/stratified_logistic.h"
#include "analysis/statistics/wilson.h"
#include "analysis/tally.h"

namespace obscura::analysis {

/// The level below which a p-value is called significant, as in Jakobsen 2010.
inline constexpr double kSignificance = 0.05;
inline constexpr double kConfidence = 0.95;

/// A difference of shares that a study is taken to care about, where it fixes no margin: from one
/// half to kRelevantShare, or between two levels of validity.
inline constexpr double kRelevantDifference = .15;

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
    /// middle. Of two levels: log odds at the second less those at the first.
    ModelTerm effect;
    Possible<ModelTerm> order = Possible<ModelTerm>::none("not known");  ///< for the second image
    double sd = 0.0;  ///< of the participants, log odds
    /// Likelihood ratio of a term for each condition.
    Possible<ChiSquareTest> conditions_differ = Possible<ChiSquareTest>::none("one condition");
};

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

/// How the order of showing was tested over participants, whose answers hang together.
enum class OrderTestKind {
    kSideGroups,  ///< side is constant for each: those who saw B second against those who saw it
                  ///< first
    kSignFlip     ///< it varies for each: votes for the second image less those for the first
};

struct OrderByParticipant {
    OrderTestKind kind = OrderTestKind::kSignFlip;
    std::int64_t participants = 0;
    std::int64_t left_out = 0;  ///< who did not answer as many conditions as the others
    PValue p;
    bool is_exact = true;
    /// By how much more often the second image is chosen than the first, -1 to 1.
    double difference = 0.0;
    Possible<Interval> interval = Possible<Interval>::none("too few participants");  ///< 95 %, by t
};

struct OrderBias {
    OrderVotes votes;
    /// As if every answer were independent, which they are not: the test to read is by_participant.
    Possible<PValue> exact = Possible<PValue>::none("no votes");
    Possible<OrderByParticipant> by_participant = Possible<OrderByParticipant>::none("not known");
    /// With a term for each condition, so that unbalanced orders do no harm.
    Possible<OrderBiasTest> logistic = Possible<OrderBiasTest>::none("not counted");
};

/// What the standard errors of a scale rest on.
enum class ScaleErrors {
    kParticipants,  ///< whose votes hang together: the sandwich over participants
    kVotes,         ///< taken as independent: who gave them is not known
    kPrior          ///< a prior, without which votes that separate have no finite scale
};

/// In JOD, the standard deviation of the prior of every difference: two of three differences are
/// thought to lie within what 91 % choose.
inline constexpr double kScalePriorJod = 2.0;

/// The variants that the study's pairs connect, on one scale.
struct VariantScale {
    std::vector<std::string> variants;                                  ///< the reference first
    Possible<Scale> bradley_terry = Possible<Scale>::none("no votes");  ///< in log odds
    Possible<Scale> thurstone = Possible<Scale>::none("no votes");      ///< in JOD
    ScaleErrors errors = ScaleErrors::kVotes;
    bool has_order_term = false;  ///< in both, where the order of showing is known
    /// Why there is a prior; empty where there is none.
    std::string separated;
    /// 95 % of each variant's JOD, by t over participants where they are known; the reference's is
    /// 0 to 0.
    Possible<std::vector<Interval>> jod_intervals =
        Possible<std::vector<Interval>>::none("no votes");
};

/// How attentive and how fast one participant was.
struct ParticipantResult {
    std::string id;
    std::int64_t votes = 0;
    Successes catch_trials;   ///< with the expected answer
    Successes repeats;        ///< with the same answer again
    Successes with_majority;  ///< votes that are those of most others in their condition
    Possible<double> median_time_s = Possible<double>::none("no response times");
    std::vector<std::string> left_out;  ///< why the study's rule leaves him out; empty: it does not
};

/// How attentive the participants were. Quartiles are of the participants' own shares.
struct Attention {
    std::vector<ParticipantResult> participants;  ///< all of them, also those left out
    Successes catch_trials;                       ///< of all together
    Successes repeats;
    Possible<Quartiles> catch_share = Possible<Quartiles>::none("no values");
    Possible<Quartiles> repeat_share = Possible<Quartiles>::none("no values");
    Possible<Quartiles> majority_share = Possible<Quartiles>::none("no values");
};

/// Response times in s, of participants: each gives one, the median of his own.
struct ResponseTimeSummary {
    Quartiles seconds;
    /// 95 % of the median, from order statistics: no assumption on the times but that participants
    /// are independent.
    Possible<Interval> median_interval = Possible<Interval>::none("too few values");
};

struct ResponseTimes {
    ResponseTimeSummary overall;
    std::vector<Possible<ResponseTimeSummary>> by_condition;  ///< as Analysis::conditions
};

/// Answers of a participant below which his times show no trend.
inline constexpr std::size_t kFewestForTrend = 3;

/// How a participant's response time changes from one trial to the next: the median slope over the
/// participants, each with the median slope of his own times.
struct TimeTrend {
    std::int64_t participants = 0;
    double slope_s = 0.0;  ///< seconds for each further trial
    Possible<Interval> interval = Possible<Interval>::none("too few values");  ///< 95 %
};

/// What changes over the session.
struct Learning {
    Possible<TimeTrend> time = Possible<TimeTrend>::none("not known");
    /// Log odds of choosing B for each further trial, with a term for each condition.
    Possible<StratifiedSlope> choice = Possible<StratifiedSlope>::none("not known");
};

/// Shares at which the power of what was run is said, and the smallest that a study is taken to
/// care about: a share of B of at least this, or at most as far below one half.
inline constexpr double kPowerShares[] = {.60, .65, .70, .75};
inline constexpr double kRelevantShare = .65;
/// The power that is asked for.
inline constexpr double kAskedPower = .8;

/// What the number of votes that a condition got could show, whatever they were: at the share that
/// was observed, power would say nothing that the p-value does not (J. M. Hoenig and D. M. Heisey
/// 2001).
struct RunPower {
    struct At {
        double share = 0.0;
        TestPower exact;
        TestPower chi_square;
        TestPower
            holm;  ///< exact, at the level that passes Holm's correction whatever the others do
    };
    std::int64_t n = 0;      ///< votes of a condition: the median over those that have any
    std::size_t tests = 1;   ///< conditions that are tested
    std::vector<At> shares;  ///< as kPowerShares
    /// The smallest share that n votes detect with kAskedPower.
    Possible<double> detectable = Possible<double>::none("no share");
    Possible<double> detectable_holm = Possible<double>::none("no share");
};

/// What the answers say about a hypothesis.
enum class Conclusion { kUndecided, kBPreferred, kAPreferred, kEqual, kDiffers, kSame, kNotTested };

/// `undecided`, `B preferred over A`, `A preferred over B`, `practically equal (within 15 points)`;
/// on validity `the effect differs with lighting`, `equal within 15 points`; `not tested`.
[[nodiscard]] std::string to_string(Conclusion conclusion, double margin);

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
    std::string sentence;  ///< with the conclusion and its numbers
};

/// The conclusion with its direction and whether it is small: `B preferred over A by less than the
/// relevant 15 points`.
[[nodiscard]] std::string verdict_words(const Verdict& verdict);

/// The confidence of intervals that lie within a margin just where two one-sided tests at
/// kSignificance say so.
inline constexpr double kEqualityConfidence = 1.0 - 2.0 * kSignificance;

/// How verdicts are reached, in words.
[[nodiscard]] std::string verdict_rule();

struct Analysis;

/// Whom the study's rule leaves out, and what that changes.
struct Exclusions {
    ExclusionRule rule;
    std::int64_t participants = 0;  ///< before
    std::int64_t left_out = 0;
    std::vector<std::string> changes;  ///< conclusions that differ, each in a sentence
    /// The same analysis of everybody; nothing where the rule leaves nobody out.
    std::shared_ptr<const Analysis> everybody;
};

/// The answers to the study's questions.
struct Analysis {
    Tally tally;
    std::vector<ConditionResult> conditions;
    std::string sentence;  ///< what the conditions say, before and after Holm
    Family family;
    /// Which look at the answers this is; verdicts are at that look.
    Possible<LookResult> look = Possible<LookResult>::none("not known");
    std::vector<HypothesisResult> hypotheses;  ///< those on a preference, as in the family
    Possible<ValidityResult> validity = Possible<ValidityResult>::none("not asked");
    Possible<OrderBias> order_bias = Possible<OrderBias>::none("not counted");
    std::vector<VariantScale> scales;  ///< one for each group that pairs connect, with votes
    std::vector<Verdict> verdicts;     ///< in order of their names, that on validity among them
    Possible<RunPower> power = Possible<RunPower>::none("no votes");
    /// Nothing where only counts are known.
    Possible<Attention> attention = Possible<Attention>::none("counts do not say who voted");
    Possible<ResponseTimes> response_times = Possible<ResponseTimes>::none("not known");
    Possible<Learning> learning = Possible<Learning>::none("not known");
    /// What the study's rule does. The analysis is of those who stay.
    Possible<Exclusions> exclusions = Possible<Exclusions>::none("no rule");
    bool has_model = false;  ///< whether mixed models were asked for
    /// What came of a pre-registration, where one was given to compare with.
    Possible<RegistrationResult> registration =
        Possible<RegistrationResult>::none("no pre-registration was given");
};

/// The seed of what is simulated for an analysis: what its looks do to 5 %.
inline constexpr std::uint64_t kAnalysisSeed = 20100501;

struct AnalysisOptions {
    /// Whether each verdict is checked by a mixed model: some 10 s for a million answers.
    bool model = false;
};

/// Linear in the votes. Where the sessions carry a rule of exclusion, the analysis is of the
/// participants whom it leaves in, and Exclusions::everybody that of all.
[[nodiscard]] Analysis analyse(Tally tally, const AnalysisOptions& options = {});

/// The verdicts of that analysis alone, without what none of them rests on: for simulations, which
/// ask it thousands of times.
[[nodiscard]] std::vector<Verdict> verdicts_on(Tally tally);

}  // namespace obscura::analysis
