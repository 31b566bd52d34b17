// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/report/analysis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/report/participants.h"
#include "analysis/report/resampled.h"
#include "analysis/report/run_power.h"
#include "analysis/report/same_participants.h"
#include "analysis/report/variant_scales.h"
#include "analysis/report/verdicts.h"
#include "analysis/statistics/benjamini_hochberg.h"
#include "analysis/statistics/clopper_pearson.h"
#include "analysis/statistics/cohens_g.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/fisher_exact.h"
#include "analysis/statistics/holm.h"
#include "analysis/statistics/share_difference.h"

namespace obscura::analysis {
namespace {

constexpr std::array<std::string_view, 3> kLevels{"low", "moderate", "high"};

Preference preference_of(const Votes& votes) {
    Preference preference;
    preference.votes = votes;
    if (votes.n() > 0) {
        preference.share_b = static_cast<double>(votes.b) / static_cast<double>(votes.n());
    }
    preference.chi_square = chi_square_equal_split(votes);
    preference.exact = exact_binomial(votes.b, votes.n());
    preference.wilson = wilson(votes.b, votes.n(), kConfidence);
    preference.clopper_pearson = clopper_pearson(votes.b, votes.n(), kConfidence);
    preference.cohens_g = cohens_g(votes);
    preference.posterior = posterior_flat(votes.b, votes.n(), kConfidence);
    preference.bayes_factor = bayes_factor(votes.b, votes.n());
    return preference;
}

std::vector<ConditionResult> test_conditions(const Tally& tally) {
    std::vector<ConditionResult> results;
    std::vector<double> family;
    for (const ConditionVotes& condition : tally.conditions) {
        ConditionResult result;
        result.condition = {condition.id,        condition.hypothesis, condition.validity,
                            condition.variant_a, condition.variant_b,  condition.votes};
        result.preference = preference_of(condition.votes);
        if (result.preference.chi_square.has_value()) {
            family.push_back(result.preference.chi_square->p.p);
        }
        results.push_back(std::move(result));
    }
    const std::vector<double> by_holm = holm(family);
    const std::vector<double> by_rate = benjamini_hochberg(family);
    std::size_t next = 0;
    for (ConditionResult& result : results) {
        if (!result.preference.chi_square.has_value()) continue;
        result.p_holm = by_holm[next];
        result.p_bh = by_rate[next];
        ++next;
    }
    return results;
}

bool is_significant(const Possible<ChiSquareTest>& test) {
    return test.has_value() && test->p.p < kSignificance;
}

std::string test_words(const ChiSquareTest& test) {
    return fmt::format("chi-square {:.4g}, df {}, p {}", test.statistic, test.df, p_text(test.p));
}

std::string sentence_of(const HypothesisResult& result, std::size_t tests) {
    if (!result.pooled.chi_square.has_value()) {
        return fmt::format("{}: no votes, so nothing can be said.", result.name);
    }
    const Votes& votes = result.pooled.votes;
    const bool differs = is_significant(result.pooled.chi_square);
    const char* verdict = !differs            ? "no significant difference from an equal split"
                          : votes.b > votes.a ? "B was preferred"
                                              : "A was preferred";
    return fmt::format(
        "{} ({}): together {} votes for A and {} for B ({:.1f} % B), {}: {}. Alone {} of its {} "
        "conditions {} significant at {:g}, after Holm's correction for {} tests {}.",
        result.name, fmt::join(result.conditions, ", "), votes.a, votes.b,
        100.0 * *result.pooled.share_b, test_words(*result.pooled.chi_square), verdict,
        result.significant, result.conditions.size(), result.significant == 1 ? "is" : "are",
        kSignificance, tests, result.significant_holm);
}

std::string sentence_of(const std::vector<ConditionResult>& conditions) {
    std::vector<std::string> alone;
    std::vector<std::string> corrected;
    std::size_t tests = 0;
    for (const ConditionResult& result : conditions) {
        if (!result.p_holm.has_value()) continue;
        ++tests;
        if (is_significant(result.preference.chi_square)) alone.push_back(result.condition.id);
        if (*result.p_holm < kSignificance) corrected.push_back(result.condition.id);
    }
    const auto list = [](const std::vector<std::string>& ids) {
        return ids.empty() ? std::string("none") : fmt::format("{}", fmt::join(ids, ", "));
    };
    return fmt::format(
        "Significant at {:g} each for itself: {}. Still so after Holm's correction for {} tests: "
        "{}.",
        kSignificance, list(alone), tests, list(corrected));
}

std::vector<HypothesisResult> test_hypotheses(const std::vector<ConditionResult>& conditions) {
    std::map<std::string, HypothesisResult> by_name;
    std::size_t tests = 0;
    for (const ConditionResult& result : conditions) {
        if (result.p_holm.has_value()) ++tests;
        if (result.condition.hypothesis.empty()) continue;
        HypothesisResult& hypothesis = by_name[result.condition.hypothesis];
        hypothesis.name = result.condition.hypothesis;
        hypothesis.conditions.push_back(result.condition.id);
        hypothesis.pooled.votes.a += result.condition.votes.a;
        hypothesis.pooled.votes.b += result.condition.votes.b;
        if (is_significant(result.preference.chi_square)) ++hypothesis.significant;
        if (result.p_holm.has_value() && *result.p_holm < kSignificance) {
            ++hypothesis.significant_holm;
        }
    }
    std::vector<HypothesisResult> results;
    for (auto& [name, hypothesis] : by_name) {
        hypothesis.pooled = preference_of(hypothesis.pooled.votes);
        hypothesis.sentence = sentence_of(hypothesis, tests);
        results.push_back(std::move(hypothesis));
    }
    return results;
}

/// Conditions that show the same two variants, in order of the levels.
using Family = std::vector<const ConditionVotes*>;

std::vector<Family> families_of(const Tally& tally) {
    std::vector<Family> families;
    std::map<std::pair<std::string, std::string>, std::size_t> place;
    for (const ConditionVotes& condition : tally.conditions) {
        const auto key = std::pair(condition.variant_a, condition.variant_b);
        const auto [entry, is_new] = place.emplace(key, families.size());
        if (is_new) families.emplace_back();
        families[entry->second].push_back(&condition);
    }
    const auto level = [](const ConditionVotes* condition) {
        return std::find(kLevels.begin(), kLevels.end(), condition->validity);
    };
    for (Family& family : families) {
        std::stable_sort(family.begin(), family.end(), [&](const auto* one, const auto* other) {
            return level(one) < level(other);
        });
    }
    return families;
}

Comparison by_level(const Family& family) {
    Comparison comparison;
    comparison.variant_a = family.front()->variant_a;
    comparison.variant_b = family.front()->variant_b;
    for (const ConditionVotes* condition : family) {
        if (comparison.levels.empty() || comparison.levels.back() != condition->validity) {
            comparison.levels.push_back(condition->validity);
            comparison.votes.emplace_back();
        }
        comparison.conditions.push_back(condition->id);
        comparison.votes.back().a += condition->votes.a;
        comparison.votes.back().b += condition->votes.b;
    }
    comparison.test = chi_square_homogeneity(comparison.votes);
    if (comparison.votes.size() == 2) {
        comparison.fisher = fisher_exact(comparison.votes[0], comparison.votes[1]);
    }
    comparison.same_participants = same_participants(family);
    return comparison;
}

/// Of every two levels, from counts.
std::vector<LevelDifference> differences_of(const Comparison& comparison) {
    std::vector<LevelDifference> differences;
    for (std::size_t from = 0; from < comparison.votes.size(); ++from) {
        for (std::size_t to = from + 1; to < comparison.votes.size(); ++to) {
            const Votes& one = comparison.votes[from];
            const Votes& other = comparison.votes[to];
            const auto interval = share_difference(one, other, kConfidence);
            if (!interval.has_value()) continue;
            const double difference =
                static_cast<double>(other.b) / static_cast<double>(other.n()) -
                static_cast<double>(one.b) / static_cast<double>(one.n());
            differences.push_back({from, to, difference, *interval, false});
        }
    }
    return differences;
}

/// With the test that fits what is known.
std::string sentence_of(const Comparison& comparison) {
    const Possible<PValue> p = p_of(comparison);
    if (!p.has_value()) return fmt::format("no test, {}.", p.reason);
    return fmt::format("{}: {}.", test_words(comparison),
                       p->p < kSignificance ? "the levels differ"
                                            : "no significant difference between the levels");
}

std::string sentence_of(const std::vector<Comparison>& comparisons) {
    if (comparisons.empty()) {
        return "No two variants were shown at more than one level of validity, so nothing can be "
               "said about its influence.";
    }
    std::string sentence = "Does the preference depend on validity?";
    for (const Comparison& comparison : comparisons) {
        sentence +=
            fmt::format(" {} against {} over {} ({}): ", comparison.variant_a, comparison.variant_b,
                        fmt::join(comparison.levels, ", "), fmt::join(comparison.conditions, ", "));
        sentence += sentence_of(comparison);
    }
    return sentence;
}

ValidityResult test_validity(const Tally& tally) {
    ValidityResult result;
    for (const Family& family : families_of(tally)) {
        if (family.front()->validity == family.back()->validity) continue;
        result.by_level.push_back(by_level(family));
        result.by_level.back().differences = differences_of(result.by_level.back());
        if (family.size() > kMostPairedConditions) continue;
        for (std::size_t i = 0; i < family.size(); ++i) {
            for (std::size_t j = i + 1; j < family.size(); ++j) {
                if (family[i]->validity == family[j]->validity) continue;
                result.by_pair.push_back(by_level({family[i], family[j]}));
            }
        }
    }
    result.sentence = sentence_of(result.by_level);
    return result;
}

std::vector<OrderStratum> order_strata(const Tally& tally) {
    std::vector<OrderStratum> strata;
    for (const ConditionVotes& condition : tally.conditions) {
        OrderStratum& stratum = strata.emplace_back();
        for (const Answer& answer : condition.answers) {
            Votes& votes = answer.b_second ? stratum.b_second : stratum.b_first;
            ++(answer.chose_b ? votes.b : votes.a);
        }
    }
    return strata;
}

/// Each hypothesis's votes for B less those for A, of each participant.
void test_participants(std::vector<HypothesisResult>& hypotheses, const Tally& tally) {
    std::map<std::string_view, HypothesisResult*> by_name;
    for (HypothesisResult& result : hypotheses) by_name.emplace(result.name, &result);
    for (const auto& [name, result] : by_name) {
        std::vector<std::int64_t> differences(tally.participants.size());
        for (const ConditionVotes& condition : tally.conditions) {
            if (condition.hypothesis != name) continue;
            for (const Answer& answer : condition.answers) {
                differences[static_cast<std::size_t>(answer.participant)] +=
                    answer.chose_b ? 1 : -1;
            }
        }
        result->by_participant = sign_flip(differences);
    }
}

/// What needs to know who gave each answer.
void analyse_participants(Analysis& analysis, std::uint64_t seed) {
    const Tally& tally = analysis.tally;
    const VotesByParticipant votes(tally);
    test_participants(analysis.hypotheses, tally);
    analysis.attention = attention_of(tally, votes);
    analysis.response_times = response_times(tally, votes);
    analysis.learning = learning_of(tally, votes);
    resample(analysis, votes, seed);
}

/// The analysis of all who are in the tally.
Analysis analyse_all(Tally tally, std::uint64_t seed) {
    Analysis analysis;
    analysis.tally = std::move(tally);
    analysis.conditions = test_conditions(analysis.tally);
    analysis.sentence = sentence_of(analysis.conditions);
    analysis.hypotheses = test_hypotheses(analysis.conditions);
    analysis.validity = test_validity(analysis.tally);
    analysis.scales = variant_scales(analysis.tally);
    const Possible<OrderVotes>& order = analysis.tally.order;
    if (order.has_value()) {
        analysis.order_bias = OrderBias{*order, exact_binomial(order->second_chosen, order->n),
                                        order_bias(order_strata(analysis.tally))};
    } else {
        analysis.order_bias = Possible<OrderBias>::none(order.reason);
    }
    analysis.resampling.seed = seed;
    if (analysis.tally.participants.empty()) {
        const char* const why = "the answers of each participant are not known";
        analysis.response_times = Possible<ResponseTimes>::none(why);
        analysis.learning = Possible<Learning>::none(why);
        for (HypothesisResult& result : analysis.hypotheses) {
            result.by_participant = Possible<SignFlipTest>::none(why);
            result.resampled = Possible<Bounds>::none(why);
        }
        for (VariantScale& scale : analysis.scales) {
            scale.resampled_jod = Possible<std::vector<Bounds>>::none(why);
        }
    } else {
        analyse_participants(analysis, seed);
    }
    analysis.power = run_power(analysis.conditions, analysis.hypotheses);
    analysis.verdicts = verdicts_of(analysis);
    return analysis;
}

std::vector<bool> left_out_by(const Attention& attention) {
    std::vector<bool> left_out;
    for (const ParticipantResult& who : attention.participants) {
        left_out.push_back(!who.left_out.empty());
    }
    return left_out;
}

}  // namespace

Analysis analyse(Tally tally, std::uint64_t seed) {
    Analysis everybody = analyse_all(std::move(tally), seed);
    if (!everybody.tally.exclusion.has_value()) {
        everybody.exclusions = Possible<Exclusions>::none(everybody.tally.exclusion.reason);
        return everybody;
    }
    const std::vector<bool> left_out = left_out_by(*everybody.attention);
    Exclusions exclusions;
    exclusions.rule = *everybody.tally.exclusion;
    exclusions.participants = static_cast<std::int64_t>(left_out.size());
    exclusions.left_out = std::count(left_out.begin(), left_out.end(), true);
    if (exclusions.left_out == 0) {
        everybody.exclusions = exclusions;
        return everybody;
    }
    Tally kept = without(everybody.tally, left_out);
    for (ConditionVotes& condition : everybody.tally.conditions) {
        condition.answers = std::vector<Answer>();
    }
    Analysis analysis = analyse_all(std::move(kept), seed);
    analysis.attention = everybody.attention;
    exclusions.changes = changed_conclusions(analysis, everybody);
    exclusions.everybody = std::make_shared<const Analysis>(std::move(everybody));
    analysis.exclusions = exclusions;
    return analysis;
}

std::string p_text(const PValue& p) {
    constexpr double kShownAsPower = 1e-290;
    constexpr double kShownWithExponent = 1e-3;
    if (p.p < kShownAsPower) return fmt::format("10^{:.2f}", p.log10_p);
    return p.p < kShownWithExponent ? fmt::format("{:.3e}", p.p) : fmt::format("{:.6f}", p.p);
}

}  // namespace obscura::analysis
