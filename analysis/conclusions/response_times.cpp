// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "analysis/conclusions/participants.h"
#include "analysis/statistics/stratified_logistic.h"

namespace obscura::analysis {
namespace {

Possible<ResponseTimeSummary> summary_of(std::vector<double>& times_s) {
    const Possible<Quartiles> parts = quartiles(times_s);
    if (!parts.has_value()) return Possible<ResponseTimeSummary>::none("no response times");
    return ResponseTimeSummary{*parts, median_interval(times_s, kConfidence)};
}

/// One time for each participant: the median of his own.
std::vector<double> one_each(std::vector<std::pair<std::int32_t, double>>& times) {
    const auto before = [](const auto& one, const auto& other) { return one.first < other.first; };
    if (!std::is_sorted(times.begin(), times.end(), before)) {
        std::stable_sort(times.begin(), times.end(), before);
    }
    std::vector<double> medians;
    medians.reserve(times.size());
    std::vector<double> own;
    for (std::size_t i = 0; i < times.size();) {
        own.clear();
        const std::int32_t who = times[i].first;
        for (; i < times.size() && times[i].first == who; ++i) own.push_back(times[i].second);
        medians.push_back(own.size() == 1 ? own.front() : quartiles(own)->median);
    }
    return medians;
}

/// Each participant's slope of time over position.
Possible<TimeTrend> time_trend(const VotesByParticipant& votes) {
    std::vector<double> slopes;
    std::vector<std::pair<double, double>> points;
    for (std::size_t participant = 0; participant < votes.participants(); ++participant) {
        points.clear();
        for (const auto& vote : votes.of(participant)) {
            const Answer& answer = votes.answer(vote);
            if (answer.position < 0 || answer.response_time_s <= 0.0) continue;
            points.emplace_back(answer.position, answer.response_time_s);
        }
        if (points.size() < kFewestForTrend) continue;
        std::sort(points.begin(), points.end());
        const Possible<double> slope = median_slope(points);
        if (slope.has_value()) slopes.push_back(*slope);
    }
    const Possible<Quartiles> parts = quartiles(slopes);
    if (!parts.has_value()) {
        return Possible<TimeTrend>::none(
            "no participant has three or more response times with their places in the session");
    }
    return TimeTrend{parts->n, parts->median, median_interval(slopes, kConfidence)};
}

/// The choice of B over the position, with a term for each condition.
Possible<StratifiedSlope> choice_trend(const Tally& tally) {
    std::vector<LogisticStratum> strata;
    bool is_known = false;
    for (const ConditionVotes& condition : tally.conditions) {
        std::map<std::int32_t, Votes> by_position;
        for (const Answer& answer : condition.answers) {
            if (answer.position < 0) continue;
            is_known = true;
            Votes& votes = by_position[answer.position];
            ++(answer.chose_b ? votes.b : votes.a);
        }
        LogisticStratum& stratum = strata.emplace_back();
        for (const auto& [position, votes] : by_position) {
            stratum.push_back({static_cast<double>(position), votes});
        }
    }
    if (!is_known) {
        return Possible<StratifiedSlope>::none(
            "the place of each trial in its session is not known");
    }
    return stratified_slope(strata);
}

}  // namespace

Possible<ResponseTimes> response_times(const Tally& tally, const VotesByParticipant& votes) {
    ResponseTimes result;
    std::vector<std::pair<std::int32_t, double>> times;
    for (const ConditionVotes& condition : tally.conditions) {
        times.clear();
        for (const Answer& answer : condition.answers) {
            if (answer.response_time_s > 0.0) {
                times.emplace_back(answer.participant, answer.response_time_s);
            }
        }
        std::vector<double> medians = one_each(times);
        result.by_condition.push_back(summary_of(medians));
    }
    std::vector<double> medians;
    std::vector<double> own;
    for (std::size_t participant = 0; participant < votes.participants(); ++participant) {
        own.clear();
        for (const auto& vote : votes.of(participant)) {
            const double time_s = votes.answer(vote).response_time_s;
            if (time_s > 0.0) own.push_back(time_s);
        }
        if (!own.empty()) medians.push_back(quartiles(own)->median);
    }
    const Possible<ResponseTimeSummary> overall = summary_of(medians);
    if (!overall.has_value()) {
        return Possible<ResponseTimes>::none("the response times are not known");
    }
    result.overall = *overall;
    return result;
}

Possible<Learning> learning_of(const Tally& tally, const VotesByParticipant& votes) {
    if (tally.participants.empty()) {
        return Possible<Learning>::none("counts do not say when in its session a vote was given");
    }
    return Learning{time_trend(votes), choice_trend(tally)};
}

}  // namespace obscura::analysis
