// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "analysis/statistics/quartiles.h"

namespace obscura::analysis {

/// Votes of one participant in one condition.
struct PatternVotes {
    std::uint32_t condition = 0;  ///< place in the list of conditions
    Votes votes;
};

/// What some participants answered, all of them alike.
struct AnswerPattern {
    std::vector<PatternVotes> votes;
    std::int64_t participants = 0;  ///< 1 or more
};

/// The bootstrap over participants (B. Efron 1979): as many are drawn with replacement as there
/// are, each with all his answers, so that what hangs together stays together.
class Resampling {
  public:
    /// `conditions`: how many there are; every pattern's places lie below.
    Resampling(std::vector<AnswerPattern> patterns, std::size_t conditions);

    [[nodiscard]] std::int64_t participants() const { return participants_; }

    /// How many draws stay within a fraction of a second: kMostDraws for a study, fewer for a very
    /// large one. No value, with the reason, for fewer than kFewestResampled participants, and when
    /// not even kFewestDraws would.
    [[nodiscard]] Possible<int> draws() const;

    /// Gives `take` the votes of all conditions in each of `draws` samples. The same seed gives the
    /// same samples.
    void run(int draws, std::uint64_t seed,
             const std::function<void(const std::vector<Votes>&)>& take) const;

  private:
    std::vector<AnswerPattern> patterns_;
    std::size_t conditions_;
    std::int64_t participants_ = 0;
    double work_ = 0.0;                      ///< of one draw, in additions
    std::vector<std::uint32_t> pattern_of_;  ///< each participant's, where drawn one by one
};

inline constexpr int kMostDraws = 2000;
inline constexpr int kFewestDraws = 200;
inline constexpr std::int64_t kFewestResampled = 10;

/// The percentile interval (B. Efron and R. J. Tibshirani 1993, section 13.3) of what was computed
/// for each sample; sorts it. No value without samples.
[[nodiscard]] Possible<Interval> percentile_interval(std::vector<double>& values,
                                                     double confidence = 0.95);

}  // namespace obscura::analysis
