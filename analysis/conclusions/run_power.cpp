// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/run_power.h"
#include "analysis/conclusions/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace obscura::analysis {
namespace {

/// A share nearer to one half than this needs thousands of participants; how many is of no use.
constexpr double kNearHalf = 0.02;
/// More conditions than this are not asked one by one.
constexpr std::size_t kMostAsked = 40;

/// Participants needed, each share and level looked up once.
class Needs {
  public:
    explicit Needs(double holm_level) : holm_level_(holm_level) {}

    RunPower::Needed of(const std::string& name, double share_b) {
        RunPower::Needed needed;
        needed.name = name;
        needed.share_b = share_b;
        needed.exact = at(share_b, kSignificance);
        needed.holm = at(share_b, holm_level_);
        return needed;
    }

  private:
    Possible<std::int64_t> at(double share_b, double level) {
        // Either side alike; no share is so sure that one vote is enough.
        const double share = std::min(std::max(share_b, 1.0 - share_b), 1.0 - kSmallestEffect);
        if (share < 0.5 + kNearHalf) {
            return Possible<std::int64_t>::none(
                fmt::format("the observed share is within {:g} of one half", kNearHalf));
        }
        const auto known = known_.find({share, level});
        if (known != known_.end()) return known->second;
        const auto needed = participants_needed(SplitTest::kExact, share, level, kAskedPower);
        known_.emplace(std::pair(share, level), needed);
        return needed;
    }

    double holm_level_;
    std::map<std::pair<double, double>, Possible<std::int64_t>> known_;
};

/// The smallest share above one half that n votes detect: the power grows with it.
Possible<double> detectable_share(std::int64_t n, double level) {
    constexpr double kSure = 1.0 - 1e-9;
    const auto is_enough = [&](double share) {
        return power_of(SplitTest::kExact, n, share, level).power >= kAskedPower;
    };
    if (!is_enough(kSure)) {
        return Possible<double>::none(
            fmt::format("{} detect{} no share", counted(n, "vote"), n == 1 ? "s" : ""));
    }
    double low = 0.5;
    double high = kSure;
    while (high - low > 1e-7) {
        const double middle = (low + high) / 2.0;
        (is_enough(middle) ? high : low) = middle;
    }
    return high;
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

Possible<RunPower> run_power(const std::vector<ConditionResult>& conditions,
                             const std::vector<HypothesisResult>& hypotheses) {
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
    power.detectable = detectable_share(power.n, kSignificance);
    power.detectable_holm = detectable_share(power.n, holm_level);
    Needs needs(holm_level);
    if (conditions.size() <= kMostAsked) {
        for (const ConditionResult& result : conditions) {
            if (!result.preference.share_b.has_value()) continue;
            power.conditions.push_back(needs.of(result.condition.id, *result.preference.share_b));
        }
    }
    if (hypotheses.size() <= kMostAsked) {
        for (const HypothesisResult& result : hypotheses) {
            if (!result.pooled.share_b.has_value()) continue;
            power.hypotheses.push_back(needs.of(result.name, *result.pooled.share_b));
        }
    }
    return power;
}

}  // namespace obscura::analysis
