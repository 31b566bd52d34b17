// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/resampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/binomial_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

namespace obscura::analysis {
namespace {

/// Additions within a fraction of a second.
constexpr double kMostWork = 4e8;
/// What a binomial number and the number of a participant cost, in additions.
constexpr double kBinomialWork = 30.0;
constexpr double kParticipantWork = 6.0;

using Random = boost::random::mt19937_64;

/// How often each pattern was drawn: one binomial number a pattern where they are few (the
/// conditional method for the multinomial distribution; L. Devroye 1986, chapter 11).
void draw(const std::vector<AnswerPattern>& patterns, std::int64_t participants, Random& random,
          std::vector<std::int64_t>& drawn) {
    std::int64_t left = participants;
    std::int64_t of = participants;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const std::int64_t size = patterns[i].participants;
        if (left == 0 || of == size) {
            drawn[i] = left;
        } else {
            const double share = static_cast<double>(size) / static_cast<double>(of);
            drawn[i] = boost::random::binomial_distribution<std::int64_t>(left, share)(random);
        }
        left -= drawn[i];
        of -= size;
    }
}

/// The same where nearly everybody answered differently: one participant after another.
void draw_each(const std::vector<std::uint32_t>& pattern_of, Random& random,
               std::vector<std::int64_t>& drawn) {
    std::fill(drawn.begin(), drawn.end(), 0);
    boost::random::uniform_int_distribution<std::size_t> anybody(0, pattern_of.size() - 1);
    for (std::size_t i = 0; i < pattern_of.size(); ++i) ++drawn[pattern_of[anybody(random)]];
}

}  // namespace

Resampling::Resampling(std::vector<AnswerPattern> patterns, std::size_t conditions)
    : patterns_(std::move(patterns)), conditions_(conditions) {
    work_ = static_cast<double>(conditions_);
    for (const AnswerPattern& pattern : patterns_) {
        participants_ += pattern.participants;
        work_ += static_cast<double>(pattern.votes.size());
    }
    const double by_pattern = kBinomialWork * static_cast<double>(patterns_.size());
    const double by_participant = kParticipantWork * static_cast<double>(participants_);
    work_ += std::min(by_pattern, by_participant);
    if (by_pattern <= by_participant) return;
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
        pattern_of_.insert(pattern_of_.end(), static_cast<std::size_t>(patterns_[i].participants),
                           static_cast<std::uint32_t>(i));
    }
}

Possible<int> Resampling::draws() const {
    if (participants_ < kFewestResampled) {
        return Possible<int>::none(
            fmt::format("fewer than {} participants to draw from", kFewestResampled));
    }
    const double affordable = kMostWork / work_;
    if (affordable < kFewestDraws) {
        return Possible<int>::none("too many participants who answered differently to draw from");
    }
    return static_cast<int>(std::min<double>(affordable, kMostDraws));
}

void Resampling::run(int draws, std::uint64_t seed,
                     const std::function<void(const std::vector<Votes>&)>& take) const {
    Random random(seed);
    std::vector<std::int64_t> drawn(patterns_.size());
    std::vector<Votes> votes(conditions_);
    for (int i = 0; i < draws; ++i) {
        if (pattern_of_.empty()) {
            draw(patterns_, participants_, random, drawn);
        } else {
            draw_each(pattern_of_, random, drawn);
        }
        std::fill(votes.begin(), votes.end(), Votes{});
        for (std::size_t k = 0; k < patterns_.size(); ++k) {
            if (drawn[k] == 0) continue;
            for (const PatternVotes& own : patterns_[k].votes) {
                votes[own.condition].a += drawn[k] * own.votes.a;
                votes[own.condition].b += drawn[k] * own.votes.b;
            }
        }
        take(votes);
    }
}

Possible<Interval> percentile_interval(std::vector<double>& values, double confidence) {
    if (values.empty()) return Possible<Interval>::none("no samples");
    std::sort(values.begin(), values.end());
    const double tail = (1.0 - confidence) / 2.0;
    return Interval{quantile_of_sorted(values, tail), quantile_of_sorted(values, 1.0 - tail)};
}

}  // namespace obscura::analysis
