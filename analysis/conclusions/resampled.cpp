// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/resampled.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/conclusions/variant_scales.h"

namespace obscura::analysis {
namespace {

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
    ResampledScales scales(analysis);
    resampling.run(*analysis.resampling.draws, seed,
                   [&](const std::vector<Votes>& sample) { scales.take(sample); });
    scales.finish();
}

}  // namespace obscura::analysis
