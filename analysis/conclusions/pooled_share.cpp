// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/pooled_share.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <unordered_map>

#include "analysis/conclusions/words.h"
#include "analysis/statistics/clopper_pearson.h"
#include "analysis/statistics/clustered_share.h"
#include "analysis/statistics/cochran_q.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/participants_posterior.h"
#include "analysis/statistics/sign_flip.h"

namespace obscura::analysis {
namespace {

/// A condition of a hypothesis.
struct Part {
    const ConditionVotes* condition = nullptr;
    bool is_turned = false;
};
using Parts = std::vector<Part>;

using ConditionsById = std::unordered_map<std::string_view, const ConditionVotes*>;

Parts parts_of(const HypothesisResult& result, const ConditionsById& conditions) {
    Parts parts;
    for (std::size_t i = 0; i < result.conditions.size(); ++i) {
        parts.push_back({conditions.at(result.conditions[i]), result.pooling->turned[i]});
    }
    return parts;
}

/// The votes of each participant in all of the conditions together.
std::vector<Votes> votes_of_each(const Parts& parts, std::size_t participants) {
    std::vector<Votes> each(participants);
    for (const auto& [condition, is_turned] : parts) {
        for (const Answer& answer : condition->answers) {
            Votes& own = each[static_cast<std::size_t>(answer.participant)];
            ++(answer.chose_b != is_turned ? own.b : own.a);
        }
    }
    return each;
}

/// Whether the conditions differ, of the participants who answered each of them once.
Possible<Heterogeneity> heterogeneity_of(const Parts& parts, std::size_t participants) {
    using None = Possible<Heterogeneity>;
    if (parts.size() < 2) return None::none("it has one condition");
    std::vector<signed char> answers(participants * parts.size(), -1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const Answer& answer : parts[i].condition->answers) {
            const auto who = static_cast<std::size_t>(answer.participant);
            signed char& own = answers[who * parts.size() + i];
            if (own >= 0) return None::none("a participant answered a condition more than once");
            own = answer.chose_b != parts[i].is_turned ? 1 : 0;
        }
    }
    CochranSums sums(parts.size());
    Heterogeneity result;
    for (std::size_t who = 0; who < participants; ++who) {
        const auto row = std::span(answers).subspan(who * parts.size(), parts.size());
        if (std::find(row.begin(), row.end(), -1) != row.end()) continue;
        sums.add(row);
        ++result.participants;
    }
    const auto test = cochran_q(sums);
    if (!test.has_value()) return None::none(test.reason);
    result.test = *test;
    return result;
}

/// t over participants; exact, each counted once, where each voted once, where nobody differs from
/// the others and where few answered.
ShareInterval interval_of(const std::vector<Votes>& each, double share, double confidence) {
    std::int64_t participants = 0;
    std::int64_t most = 0;
    for (const Votes& votes : each) {
        if (votes.n() > 0) ++participants;
        most = std::max(most, votes.n());
    }
    if (most > 1 && participants >= kFewestForMeans) {
        const auto interval = clustered_share(each, confidence);
        if (interval.has_value()) return {*interval, ShareIntervalKind::kMeans};
    }
    return {*clopper_pearson_of_share(share, participants, confidence),
            ShareIntervalKind::kEachOnce};
}

std::int64_t most_votes_of(const Parts& parts) {
    std::int64_t most = 0;
    for (const Part& part : parts) most = std::max(most, part.condition->votes.n());
    return most;
}

/// Who gave the votes is not known: there are at least as many people as a condition has votes, and
/// the votes of each may all be alike.
void infer_from_counts(HypothesisResult& result, const Parts& parts) {
    const char* const why = "the answers of each participant are not known";
    result.by_participant = Possible<SignFlipTest>::none(why);
    result.heterogeneity = Possible<Heterogeneity>::none(why);
    const double share = *result.pooled.share_b;
    const std::int64_t people = most_votes_of(parts);
    result.each_once = exact_binomial_of_share(share, people);
    const auto interval = [&](double confidence) {
        return ShareInterval{*clopper_pearson_of_share(share, people, confidence),
                             ShareIntervalKind::kCounts};
    };
    result.interval = interval(kConfidence);
    result.equality_interval = interval(kEqualityConfidence);
    result.posterior = parts.size() == 1 ? result.pooled.posterior : Possible<Posterior>::none(why);
}

void infer_from_participants(HypothesisResult& result, const Parts& parts, std::size_t participants,
                             PooledParts said) {
    const std::vector<Votes> each = votes_of_each(parts, participants);
    std::vector<std::int64_t> differences;
    differences.reserve(each.size());
    for (const Votes& votes : each) differences.push_back(votes.b - votes.a);
    result.by_participant = sign_flip(differences);
    result.each_once = Possible<PValue>::none("each answer is known");
    const double share = *result.pooled.share_b;
    result.interval = interval_of(each, share, kConfidence);
    result.equality_interval = interval_of(each, share, kEqualityConfidence);
    if (said == PooledParts::kVerdict) return;
    result.posterior = participants_posterior(each, kConfidence);
    result.heterogeneity = heterogeneity_of(parts, participants);
}

/// What counts several votes of a participant as independent, and would contradict what does not.
void drop_what_counts_votes(Preference& pooled) {
    const char* const why = "it would count several votes of a participant as independent";
    pooled.wilson = Possible<Interval>::none(why);
    pooled.clopper_pearson = Possible<Interval>::none(why);
    pooled.posterior = Possible<Posterior>::none(why);
    pooled.bayes_factor = Possible<BayesFactor>::none(why);
}

}  // namespace

void infer_pooled_shares(std::vector<HypothesisResult>& hypotheses, const Tally& tally,
                         PooledParts said) {
    using enum ShareIntervalKind;
    ConditionsById conditions;
    for (const ConditionVotes& condition : tally.conditions) {
        conditions.emplace(condition.id, &condition);
    }
    for (HypothesisResult& result : hypotheses) {
        if (!result.pooling.has_value() || result.pooled.votes.n() == 0) continue;
        const Parts parts = parts_of(result, conditions);
        if (tally.participants.empty()) {
            infer_from_counts(result, parts);
        } else {
            infer_from_participants(result, parts, tally.participants.size(), said);
        }
        const bool is_each_once = parts.size() == 1 && result.interval->kind != kMeans;
        if (!is_each_once) drop_what_counts_votes(result.pooled);
    }
}

Possible<PValue> p_of(const HypothesisResult& result) {
    if (result.by_participant.has_value()) return result.by_participant->p;
    const bool is_of_participants =
        result.interval.has_value() && result.interval->kind != ShareIntervalKind::kCounts;
    if (is_of_participants) return PValue{};  // each of them chose both sides equally often
    return result.each_once;
}

std::string test_words(const HypothesisResult& result) {
    const Possible<PValue> p = p_of(result);
    if (!p.has_value()) return p.reason;
    if (result.by_participant.has_value()) {
        const SignFlipTest& test = *result.by_participant;
        return fmt::format(
            "{} test over participants by flipping signs, {} of them with a preference, {}",
            test.is_exact ? "exact" : "large-sample", test.participants, p_words(*p));
    }
    if (result.interval->kind != ShareIntervalKind::kCounts) {
        return fmt::format("every participant chose both sides equally often, {}", p_words(*p));
    }
    return fmt::format("exact binomial test {}{}", p_words(*p),
                       result.conditions.size() > 1
                           ? ", each participant counted once because who gave the votes is not "
                             "known"
                           : "");
}

}  // namespace obscura::analysis
