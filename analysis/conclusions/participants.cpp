// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/participants.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace obscura::analysis {
namespace {

/// Share of successes, where there were trials.
Possible<double> share_of(const Successes& trials) {
    if (trials.n == 0) return Possible<double>::none("no such trials");
    return static_cast<double>(trials.successes) / static_cast<double>(trials.n);
}

/// Whether a vote is that of most others in the condition; a tie says nothing.
void compare_with_others(const Votes& votes, bool chose_b, Successes& agreement) {
    const std::int64_t others_a = votes.a - (chose_b ? 0 : 1);
    const std::int64_t others_b = votes.b - (chose_b ? 1 : 0);
    if (others_a == others_b) return;
    ++agreement.n;
    if ((others_b > others_a) == chose_b) ++agreement.successes;
}

std::vector<std::string> reasons_to_leave_out(const ParticipantResult& who,
                                              const ExclusionRule& rule) {
    std::vector<std::string> reasons;
    const auto check = [&](const std::optional<double>& least, const Successes& trials,
                           std::string_view what) {
        const Possible<double> share = share_of(trials);
        if (!least || !share.has_value() || *share >= *least) return;
        reasons.push_back(fmt::format("{} of {} {}, a share of {:.4g} below {:g}", trials.successes,
                                      trials.n, what, *share, *least));
    };
    check(rule.min_catch_correct, who.catch_trials, "catch trials correct");
    check(rule.min_repeat_agreement, who.repeats, "repeated answers agree");
    if (rule.min_response_time_s && who.median_time_s.has_value() &&
        *who.median_time_s < *rule.min_response_time_s) {
        reasons.push_back(fmt::format("median response time {:.4g} s below {:g} s",
                                      *who.median_time_s, *rule.min_response_time_s));
    }
    return reasons;
}

Possible<Quartiles> quartiles_of_shares(const std::vector<ParticipantResult>& list,
                                        Successes ParticipantResult::*trials) {
    std::vector<double> shares;
    for (const ParticipantResult& who : list) {
        if ((who.*trials).n > 0) shares.push_back(*share_of(who.*trials));
    }
    return quartiles(shares);
}

}  // namespace

VotesByParticipant::VotesByParticipant(const Tally& tally)
    : tally_(tally), begin_(tally.participants.size() + 1) {
    const auto each = [&](const auto& take) {
        for (std::size_t i = 0; i < tally.conditions.size(); ++i) {
            const std::vector<Answer>& answers = tally.conditions[i].answers;
            for (std::size_t k = 0; k < answers.size(); ++k) {
                take(static_cast<std::size_t>(answers[k].participant),
                     Vote{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)});
            }
        }
    };
    each([&](std::size_t participant, const Vote&) { ++begin_[participant + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    votes_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    each([&](std::size_t participant, const Vote& vote) { votes_[next[participant]++] = vote; });
}

std::span<const VotesByParticipant::Vote> VotesByParticipant::of(std::size_t participant) const {
    return std::span(votes_).subspan(begin_[participant],
                                     begin_[participant + 1] - begin_[participant]);
}

Attention attention_of(const Tally& tally, const VotesByParticipant& votes) {
    Attention attention;
    attention.participants.reserve(tally.participants.size());
    std::vector<double> times;
    for (std::size_t i = 0; i < tally.participants.size(); ++i) {
        const ParticipantTrials& trials = tally.participants[i];
        ParticipantResult& who = attention.participants.emplace_back();
        who.id = trials.id;
        who.catch_trials = trials.catch_trials;
        who.repeats = trials.repeats;
        times.clear();
        for (const auto& vote : votes.of(i)) {
            const Answer& answer = votes.answer(vote);
            ++who.votes;
            compare_with_others(tally.conditions[vote.condition].votes, answer.chose_b,
                                who.with_majority);
            if (answer.response_time_s > 0.0) times.push_back(answer.response_time_s);
        }
        if (const auto median = quartiles(times); median.has_value()) {
            who.median_time_s = median->median;
        }
        if (tally.exclusion.has_value()) {
            who.left_out = reasons_to_leave_out(who, *tally.exclusion);
        }
        attention.catch_trials.n += who.catch_trials.n;
        attention.catch_trials.successes += who.catch_trials.successes;
        attention.repeats.n += who.repeats.n;
        attention.repeats.successes += who.repeats.successes;
    }
    attention.catch_share =
        quartiles_of_shares(attention.participants, &ParticipantResult::catch_trials);
    attention.repeat_share =
        quartiles_of_shares(attention.participants, &ParticipantResult::repeats);
    attention.majority_share =
        quartiles_of_shares(attention.participants, &ParticipantResult::with_majority);
    return attention;
}

}  // namespace obscura::analysis
