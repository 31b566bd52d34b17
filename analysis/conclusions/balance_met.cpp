// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/balance_met.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace obscura::analysis {
namespace {

/// Conditions beyond which nobody counts neighbours: a table of them would have a million cells.
constexpr std::size_t kMostConditions = 1000;

/// One vote's place in the session and its condition.
using SlotSide = std::pair<std::int32_t, std::size_t>;

Evenness evenness(const std::vector<std::int64_t>& counts) {
    if (counts.empty()) return {};
    const auto [low, high] = std::minmax_element(counts.begin(), counts.end());
    std::int64_t sum = 0;
    for (const std::int64_t count : counts) sum += count;
    return {*low, *high, static_cast<double>(sum) / static_cast<double>(counts.size())};
}

}  // namespace

BalanceMet balance_met(const Tally& tally) {
    BalanceMet met;
    const std::size_t conditions = tally.conditions.size();
    if (tally.participants.empty()) {
        met.unknown = "the answers of each participant are not known";
    } else if (conditions > kMostConditions) {
        met.unknown = "there are more than a thousand conditions";
    }
    if (!met.unknown.empty()) return met;
    std::vector<std::vector<SlotSide>> sessions(tally.participants.size());
    std::map<std::int32_t, std::size_t> columns;
    for (std::size_t i = 0; i < conditions; ++i) {
        for (const Answer& answer : tally.conditions[i].answers) {
            if (answer.position < 0) {
                met.unknown = "the trials are not numbered";
                return met;
            }
            sessions[static_cast<std::size_t>(answer.participant)].emplace_back(answer.position, i);
            columns.emplace(answer.position, 0);
        }
    }
    if (columns.empty()) {
        met.unknown = "nobody answered";
        return met;
    }
    std::size_t next = 0;
    for (auto& [position, column] : columns) column = next++;
    std::vector<std::int64_t> at_place(conditions * columns.size());
    std::vector<std::int64_t> after(conditions * conditions);
    for (std::vector<SlotSide>& session : sessions) {
        std::sort(session.begin(), session.end());
        for (std::size_t k = 0; k < session.size(); ++k) {
            const auto& [position, condition] = session[k];
            ++at_place[condition * columns.size() + columns.at(position)];
            if (k > 0 && session[k - 1].first == position) {
                met.unknown = "a participant has several sessions";
                return met;
            }
            if (k == 0 || session[k - 1].first + 1 != position) continue;
            ++after[session[k - 1].second * conditions + condition];
        }
    }
    std::vector<std::int64_t> of_others;  // without a condition after itself
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (i / conditions != i % conditions) of_others.push_back(after[i]);
    }
    met.at_place = evenness(at_place);
    met.after = evenness(of_others);
    return met;
}

}  // namespace obscura::analysis
