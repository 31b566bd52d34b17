// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/resampled.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "analysis/conclusions/variant_scales.h"

namespace obscura::analysis {
namespace {

using Places = std::unordered_map<std::string, std::size_t>;

double share_b(const Votes& votes) {
    return static_cast<double>(votes.b) / static_cast<double>(votes.n());
}

void add(Votes& sum, const Votes& votes, bool is_turned) {
    sum.a += is_turned ? votes.b : votes.a;
    sum.b += is_turned ? votes.a : votes.b;
}

Interval wider(const Interval& one, const Interval& other) {
    return {std::min(one.low, other.low), std::max(one.high, other.high)};
}

/// One pooled share in every sample.
class PooledShare {
  public:
    PooledShare(HypothesisResult& result, const Places& places) : result_(result) {
        for (std::size_t i = 0; i < result.conditions.size(); ++i) {
            conditions_.emplace_back(places.at(result.conditions[i]), result.pooling->turned[i]);
        }
    }
    void take(const std::vector<Votes>& votes) {
        Votes sum;
        for (const auto& [condition, is_turned] : conditions_) {
            add(sum, votes[condition], is_turned);
        }
        if (sum.n() > 0) values_.push_back(share_b(sum));
    }
    void finish() { result_.resampled = percentile_interval(values_, kConfidence); }

  private:
    HypothesisResult& result_;
    std::vector<std::pair<std::size_t, bool>> conditions_;  ///< and whether A counts as B
    std::vector<double> values_;
};

/// The differences between the levels of one comparison in every sample.
class LevelShares {
  public:
    LevelShares(Comparison& comparison, const Analysis& analysis, const Places& places)
        : comparison_(comparison), values_(comparison.differences.size()) {
        for (std::size_t i = 0; i < comparison.conditions.size(); ++i) {
            const std::size_t place = places.at(comparison.conditions[i]);
            const auto level = std::find(comparison.levels.begin(), comparison.levels.end(),
                                         analysis.conditions[place].condition.validity);
            conditions_.push_back({place,
                                   static_cast<std::size_t>(level - comparison.levels.begin()),
                                   comparison.turned[i]});
        }
    }
    void take(const std::vector<Votes>& votes) {
        std::vector<Votes> levels(comparison_.levels.size());
        for (const Part& part : conditions_) {
            add(levels[part.level], votes[part.condition], part.is_turned);
        }
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const Votes& from = levels[comparison_.differences[i].from];
            const Votes& to = levels[comparison_.differences[i].to];
            if (from.n() > 0 && to.n() > 0) values_[i].push_back(share_b(to) - share_b(from));
        }
    }
    void finish() {
        for (std::size_t i = 0; i < values_.size(); ++i) {
            LevelDifference& difference = comparison_.differences[i];
            if (difference.kind == DifferenceKind::kPaired) continue;
            const auto interval = percentile_interval(values_[i], kConfidence);
            if (!interval.has_value()) continue;
            const auto equality = percentile_interval(values_[i], kEqualityConfidence);
            difference.interval = wider(difference.interval, *interval);
            difference.equality = wider(difference.equality, *equality);
            difference.kind = DifferenceKind::kResampled;
        }
    }

  private:
    struct Part {
        std::size_t condition = 0;
        std::size_t level = 0;
        bool is_turned = false;
    };

    Comparison& comparison_;
    std::vector<Part> conditions_;
    std::vector<std::vector<double>> values_;
};

/// The scales in every sample, as many as a fraction of a second allows.
class ResampledScales {
  public:
    explicit ResampledScales(Analysis& analysis) : analysis_(analysis) {
        double work = kWorkOfCondition * static_cast<double>(analysis.conditions.size());
        for (const ConditionResult& result : analysis.conditions) {
            shown_.conditions.push_back(result.condition);
        }
        for (const VariantScale& scale : analysis.scales) {
            const auto size = static_cast<double>(scale.variants.size());
            values_.emplace_back(scale.variants.size());
            work += kWorkOfScale + kStepsOfFit * size * size * size;
        }
        most_draws_ = kMostWork / work;
    }
    void take(const std::vector<Votes>& votes) {
        if (analysis_.scales.empty() || most_draws_ < kFewestDraws || drawn_ >= most_draws_) return;
        ++drawn_;
        for (std::size_t i = 0; i < votes.size(); ++i) shown_.conditions[i].votes = votes[i];
        for (const VariantScale& scale : variant_scales(shown_, ScaleParts::kThurstone)) {
            for (std::size_t k = 0; k < values_.size(); ++k) {
                if (analysis_.scales[k].variants != scale.variants) continue;
                if (!scale.thurstone.has_value()) break;
                for (std::size_t i = 0; i < scale.variants.size(); ++i) {
                    values_[k][i].push_back(scale.thurstone->values[i]);
                }
            }
        }
    }
    void finish() {
        for (std::size_t k = 0; k < values_.size(); ++k) {
            analysis_.scales[k].resampled_jod = intervals_of(values_[k]);
        }
    }

  private:
    using None = Possible<std::vector<Interval>>;
    static constexpr double kMostWork = 3e8;
    static constexpr double kWorkOfCondition = 300.0;
    static constexpr double kWorkOfScale = 5000.0;
    static constexpr double kStepsOfFit = 10.0;
    static constexpr double kMostFailures = 0.05;  ///< beyond, the rest is no fair sample

    [[nodiscard]] None intervals_of(std::vector<std::vector<double>>& variants) const {
        if (drawn_ == 0) return None::none("too many variants to fit their scale again and again");
        const auto fitted = static_cast<double>(variants.front().size());
        if (fitted < (1.0 - kMostFailures) * drawn_) {
            return None::none(fmt::format("{} of {} samples have no finite scale",
                                          drawn_ - static_cast<int>(fitted), drawn_));
        }
        std::vector<Interval> intervals;
        for (std::vector<double>& values : variants) {
            intervals.push_back(*percentile_interval(values, kConfidence));
        }
        // The first is the reference, which stands at 0 in every sample.
        const bool is_point =
            std::any_of(intervals.begin() + 1, intervals.end(),
                        [](const Interval& interval) { return interval.low == interval.high; });
        if (is_point) return None::none("everybody answered alike: drawing anew changes nothing");
        return intervals;
    }

    Analysis& analysis_;
    Tally shown_;  ///< the conditions, with the votes of a sample
    double most_draws_ = 0.0;
    int drawn_ = 0;
    std::vector<std::vector<std::vector<double>>> values_;  ///< of each scale's variants
};

void say_why(Analysis& analysis, const std::string& why) {
    for (HypothesisResult& result : analysis.hypotheses) {
        if (result.pooling.has_value()) result.resampled = Possible<Interval>::none(why);
    }
    for (VariantScale& scale : analysis.scales) {
        scale.resampled_jod = Possible<std::vector<Interval>>::none(why);
    }
}

}  // namespace

void resample(Analysis& analysis, const VotesByParticipant& votes, std::uint64_t seed) {
    const Resampling resampling(votes.patterns(), analysis.conditions.size());
    analysis.resampling = {seed, resampling.draws()};
    if (!analysis.resampling.draws.has_value()) {
        return say_why(analysis, analysis.resampling.draws.reason);
    }
    Places places;
    for (const ConditionResult& result : analysis.conditions) {
        places.emplace(result.condition.id, places.size());
    }
    std::vector<PooledShare> pooled;
    for (HypothesisResult& result : analysis.hypotheses) {
        if (result.pooling.has_value()) pooled.emplace_back(result, places);
    }
    std::vector<LevelShares> levels;
    if (analysis.validity.has_value()) {
        for (Comparison& comparison : analysis.validity.value->by_level) {
            levels.emplace_back(comparison, analysis, places);
        }
    }
    ResampledScales scales(analysis);
    resampling.run(*analysis.resampling.draws, seed, [&](const std::vector<Votes>& sample) {
        for (PooledShare& share : pooled) share.take(sample);
        for (LevelShares& shares : levels) shares.take(sample);
        scales.take(sample);
    });
    for (PooledShare& share : pooled) share.finish();
    for (LevelShares& shares : levels) shares.finish();
    scales.finish();
}

}  // namespace obscura::analysis
