// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/hypotheses.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "analysis/conclusions/pooling.h"
#include "analysis/conclusions/words.h"
#include "analysis/statistics/clopper_pearson.h"
#include "analysis/statistics/cohens_g.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/mean_test.h"
#include "analysis/statistics/resampling.h"

namespace obscura::analysis {
namespace {

/// What is not pooled has no numbers, and says why.
Preference nothing_pooled(const std::string& why) {
    Preference preference;
    preference.share_b = Possible<double>::none(why);
    preference.chi_square = Possible<ChiSquareTest>::none(why);
    preference.exact = Possible<PValue>::none(why);
    preference.wilson = Possible<Interval>::none(why);
    preference.clopper_pearson = Possible<Interval>::none(why);
    preference.cohens_g = Possible<double>::none(why);
    preference.posterior = Possible<Posterior>::none(why);
    preference.bayes_factor = Possible<BayesFactor>::none(why);
    return preference;
}

std::string alone_words(const HypothesisResult& result, std::size_t tests) {
    return fmt::format(
        "Alone {} of its {} {} significant at {:g}, after Holm's correction for {} {}.{}",
        result.significant,
        counted(static_cast<std::int64_t>(result.conditions.size()), "condition"),
        result.significant == 1 ? "is" : "are", kSignificance,
        counted(static_cast<std::int64_t>(tests), "test"), result.significant_holm,
        result.secondary.empty()
            ? ""
            : fmt::format(" {} {} secondary and no part of it.", listed(result.secondary),
                          result.secondary.size() == 1 ? "is" : "are"));
}

std::string sentence_of(const HypothesisResult& result, std::size_t tests) {
    if (!result.pooling.has_value()) {
        return fmt::format("{} ({}): {}. {}", result.name, fmt::join(result.conditions, ", "),
                           result.pooling.reason, alone_words(result, tests));
    }
    const Possible<ChiSquareTest>& test = result.pooled.chi_square;
    if (!test.has_value()) {
        return fmt::format("{}: no votes, so nothing can be said.", result.name);
    }
    const Votes& votes = result.pooled.votes;
    return fmt::format(
        "{} ({}): together {} for A and {} for B ({:.1f} % B), chi-square {:.4g}, df {}, p {} "
        "where all votes are taken as independent. {}. {}",
        result.name, fmt::join(result.conditions, ", "), counted(votes.a, "vote"), votes.b,
        100.0 * *result.pooled.share_b, test->statistic, test->df, p_text(test->p),
        capital(result.pooling->words), alone_words(result, tests));
}

/// Votes that count as B and as A where the condition may be turned.
Votes turned(const Votes& votes, bool is_turned) {
    return is_turned ? Votes{votes.b, votes.a} : votes;
}

HypothesisResult tested(const PlannedHypothesis& planned, const std::vector<ConditionResult>& all) {
    HypothesisResult result;
    result.name = planned.id;
    result.statement = planned.statement;
    result.margin = planned.margin;
    result.is_primary = planned.is_primary;
    result.unanswered = planned.conditions;
    std::vector<const ConditionVotes*> conditions;
    for (const ConditionResult& condition : all) {
        const std::string& id = condition.condition.id;
        if (std::erase(result.unanswered, id) == 0) {
            if (condition.condition.hypothesis == planned.id) result.secondary.push_back(id);
            continue;
        }
        conditions.push_back(&condition.condition);
        result.conditions.push_back(id);
        if (is_significant(condition.preference.exact)) ++result.significant;
        if (condition.p_holm.has_value() && *condition.p_holm < kSignificance) {
            ++result.significant_holm;
        }
    }
    if (!conditions.empty()) result.pooling = pooling_of(conditions);
    if (result.pooling.has_value()) {
        Votes sum;
        for (std::size_t i = 0; i < conditions.size(); ++i) {
            const Votes votes = turned(conditions[i]->votes, result.pooling->turned[i]);
            sum.a += votes.a;
            sum.b += votes.b;
        }
        result.pooled = preference_of(sum);
    } else {
        result.pooled = nothing_pooled(result.pooling.reason);
        result.resampled = Possible<Interval>::none(result.pooling.reason);
        result.by_participant = Possible<SignFlipTest>::none(result.pooling.reason);
        result.interval = Possible<ShareInterval>::none(result.pooling.reason);
        result.equality_interval = Possible<ShareInterval>::none(result.pooling.reason);
    }
    result.sentence = sentence_of(result, all.size());
    return result;
}

/// The conditions of each hypothesis, and whether they are turned. One may serve several.
using Own = std::multimap<std::string_view, std::pair<HypothesisResult*, bool>>;

Own conditions_of(std::vector<HypothesisResult>& hypotheses) {
    Own own;
    for (HypothesisResult& result : hypotheses) {
        if (!result.pooling.has_value()) continue;
        for (std::size_t i = 0; i < result.conditions.size(); ++i) {
            own.emplace(result.conditions[i], std::pair(&result, result.pooling->turned[i]));
        }
    }
    return own;
}

bool is_part_of(const HypothesisResult& result, const ConditionVotes& condition) {
    const auto& ids = result.conditions;
    return std::find(ids.begin(), ids.end(), condition.id) != ids.end();
}

/// Participants who answered any of the hypothesis's conditions.
std::int64_t participants_of(const HypothesisResult& result, const Tally& tally) {
    std::vector<bool> answered(tally.participants.size());
    for (const ConditionVotes& condition : tally.conditions) {
        if (!is_part_of(result, condition)) continue;
        for (const Answer& answer : condition.answers) {
            answered[static_cast<std::size_t>(answer.participant)] = true;
        }
    }
    return std::count(answered.begin(), answered.end(), true);
}

std::int64_t most_votes_of(const HypothesisResult& result, const Tally& tally) {
    std::int64_t most = 0;
    for (const ConditionVotes& condition : tally.conditions) {
        if (is_part_of(result, condition)) most = std::max(most, condition.votes.n());
    }
    return most;
}

ShareInterval interval_of(const HypothesisResult& result, const Tally& tally) {
    const double share = *result.pooled.share_b;
    if (tally.participants.empty()) {
        const auto interval = wilson_of_share(share, most_votes_of(result, tally), kConfidence);
        return {{interval->low, interval->high}, ShareIntervalKind::kCounts};
    }
    const Possible<Interval>& drawn = result.resampled;
    if (drawn.has_value() && drawn->low < drawn->high) {
        return {{std::min(drawn->low, result.pooled.wilson->low),
                 std::max(drawn->high, result.pooled.wilson->high)},
                ShareIntervalKind::kResampled};
    }
    const auto interval =
        clopper_pearson_of_share(share, participants_of(result, tally), kConfidence);
    return {{interval->low, interval->high}, ShareIntervalKind::kEachOnce};
}

/// The share of B of each participant who answered any of the hypothesis's conditions.
std::vector<double> own_shares(const HypothesisResult& result, const Tally& tally) {
    std::vector<Votes> own(tally.participants.size());
    for (const ConditionVotes& condition : tally.conditions) {
        const auto place =
            std::find(result.conditions.begin(), result.conditions.end(), condition.id);
        if (place == result.conditions.end()) continue;
        const bool is_turned =
            result.pooling->turned[static_cast<std::size_t>(place - result.conditions.begin())];
        for (const Answer& answer : condition.answers) {
            Votes& votes = own[static_cast<std::size_t>(answer.participant)];
            ++(answer.chose_b != is_turned ? votes.b : votes.a);
        }
    }
    std::vector<double> shares;
    for (const Votes& votes : own) {
        if (votes.n() > 0) {
            shares.push_back(static_cast<double>(votes.b) / static_cast<double>(votes.n()));
        }
    }
    return shares;
}

/// By t of the participants' own shares; exact, each counted once, where nobody varies or few
/// answered; from counts, as many votes as one condition has.
ShareInterval equality_of(const HypothesisResult& result, const Tally& tally) {
    const double share = *result.pooled.share_b;
    if (tally.participants.empty()) {
        const auto interval =
            wilson_of_share(share, most_votes_of(result, tally), kEqualityConfidence);
        return {{interval->low, interval->high}, ShareIntervalKind::kCounts};
    }
    const std::vector<double> shares = own_shares(result, tally);
    const auto n = static_cast<std::int64_t>(shares.size());
    const auto test = mean_test(shares, kEqualityConfidence);
    if (test.has_value() && n >= kFewestResampled) {
        return {{std::max(0.0, test->interval.low), std::min(1.0, test->interval.high)},
                ShareIntervalKind::kMeans};
    }
    const auto interval = clopper_pearson_of_share(share, n, kEqualityConfidence);
    return {{interval->low, interval->high}, ShareIntervalKind::kEachOnce};
}

}  // namespace

bool is_significant(const Possible<PValue>& p) { return p.has_value() && p->p < kSignificance; }

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

std::vector<HypothesisResult> test_hypotheses(const std::vector<ConditionResult>& conditions,
                                              const Family& family) {
    std::vector<HypothesisResult> results;
    for (const PlannedHypothesis& planned : family.hypotheses) {
        if (!planned.is_interaction) results.push_back(tested(planned, conditions));
    }
    return results;
}

void test_participants(std::vector<HypothesisResult>& hypotheses, const Tally& tally) {
    const Own own = conditions_of(hypotheses);
    std::map<HypothesisResult*, std::vector<std::int64_t>> differences;
    for (const ConditionVotes& condition : tally.conditions) {
        const auto [begin, end] = own.equal_range(condition.id);
        for (auto found = begin; found != end; ++found) {
            const auto& [result, is_turned] = found->second;
            std::vector<std::int64_t>& of_each = differences[result];
            of_each.resize(tally.participants.size());
            for (const Answer& answer : condition.answers) {
                of_each[static_cast<std::size_t>(answer.participant)] +=
                    answer.chose_b != is_turned ? 1 : -1;
            }
        }
    }
    for (const auto& [result, of_each] : differences) result->by_participant = sign_flip(of_each);
}

void choose_intervals(std::vector<HypothesisResult>& hypotheses, const Tally& tally) {
    for (HypothesisResult& result : hypotheses) {
        if (result.pooled.votes.n() == 0) continue;
        result.interval = interval_of(result, tally);
        result.equality_interval = equality_of(result, tally);
    }
}

Possible<PValue> p_of(const HypothesisResult& result) {
    if (result.by_participant.has_value()) return result.by_participant->p;
    const bool is_of_participants =
        result.interval.has_value() && result.interval->kind != ShareIntervalKind::kCounts;
    if (is_of_participants) return PValue{};  // each of them chose both sides equally often
    return result.pooled.exact;
}

std::string test_words(const HypothesisResult& result) {
    const Possible<PValue> p = p_of(result);
    if (!p.has_value()) return p.reason;
    if (result.by_participant.has_value()) {
        const SignFlipTest& test = *result.by_participant;
        return fmt::format(
            "{} test over participants by flipping signs, {} of them with a preference, p {}",
            test.is_exact ? "exact" : "large-sample", test.participants, p_text(*p));
    }
    if (result.interval->kind != ShareIntervalKind::kCounts) {
        return fmt::format("every participant chose both sides equally often, p {}", p_text(*p));
    }
    return fmt::format(
        "exact binomial test p {}, with votes of the same participants taken as independent",
        p_text(*p));
}

}  // namespace obscura::analysis
