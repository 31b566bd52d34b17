// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/conclusions/comparison.h"
#include "analysis/conclusions/family.h"
#include "analysis/conclusions/looks.h"
#include "analysis/conclusions/preference.h"
#include "analysis/conclusions/verdict.h"
#include "analysis/registration.h"
#include "analysis/statistics/order_bias.h"
#include "analysis/statistics/paired_scale.h"
#include "analysis/statistics/possible.h"
#include "analysis/statistics/power.h"
#include "analysis/statistics/quartiles.h"
#include "analysis/statistics/stratified_logistic.h"
#include "analysis/tally.h"

namespace obscura::analysis {

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

/// Shares at which the power of what was run is said.
inline constexpr double kPowerShares[] = {.60, .65, .70, .75};
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
