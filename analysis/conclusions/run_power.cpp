// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/run_power.h"
#include "analysis/conclusions/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace obscura::analysis {
namespace {

Possible<double> detectable(std::int64_t n, double level) {
    const auto share = detectable_share(SplitTest::kExact, n, level, kAskedPower);
    if (share.has_value()) return share;
    return Possible<double>::none(
        fmt::format("{} detect{} no share", counted(n, "vote"), n == 1 ? "s" : ""));
}

std::int64_t median_votes(const std::vector<ConditionResult>& conditions) {
    std::vector<std::int64_t> votes;
    for (const ConditionResult& result : conditions) {
        if (result.condition.votes.n() > 0) votes.push_back(result.condition.votes.n());
    }
    if (votes.empty()) return 0;
    std::sort(votes.begin(), votes.end());
    return votes[(votes.size() - 1) / 2];
}

}  // namespace

Possible<RunPower> run_power(const std::vector<ConditionResult>& conditions) {
    using None = Possible<RunPower>;
    RunPower power;
    power.n = median_votes(conditions);
    if (power.n == 0) return None::none("no votes");
    if (power.n > kMostParticipants) {
        return None::none(fmt::format("more than {} votes", kMostParticipants));
    }
    power.tests = conditions.size();
    const double holm_level = kSignificance / static_cast<double>(power.tests);
    for (const double share : kPowerShares) {
        power.shares.push_back({share, power_of(SplitTest::kExact, power.n, share, kSignificance),
                                power_of(SplitTest::kChiSquare, power.n, share, kSignificance),
                                power_of(SplitTest::kExact, power.n, share, holm_level)});
    }
    power.detectable = detectable(power.n, kSignificance);
    power.detectable_holm = detectable(power.n, holm_level);
    return power;
}

}  // namespace obscura::analysis
