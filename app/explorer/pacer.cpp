// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/pacer.h"

#include <algorithm>
#include <cmath>

namespace obscura::app::explorer {
namespace {

/// Going up needs more room than staying, so that two sizes do not take turns.
constexpr double kRoomToGrow = 0.8;
/// Half the size has a quarter of the pixels, but the same triangles.
constexpr double kLeastGrowth = 2.0;
/// How much of the new time is believed.
constexpr double kBelief = 0.4;

}  // namespace

Pacer::Pacer(double longest_ms, bool always_whole)
    : longest_ms_(longest_ms), always_whole_(always_whole), at_(always_whole ? 0 : 1) {}

double Pacer::expected_ms(std::size_t at) const {
    if (took_ms_[at]) return *took_ms_[at];
    return at + 1 < took_ms_.size() ? kLeastGrowth * expected_ms(at + 1) : longest_ms_;
}

void Pacer::took(int divisor, double milliseconds) {
    if (!std::isfinite(milliseconds) || milliseconds < 0.0) return;
    const auto found = std::find(kDivisors.begin(), kDivisors.end(), divisor);
    if (found == kDivisors.end() || always_whole_) return;
    const auto at = static_cast<std::size_t>(found - kDivisors.begin());
    std::optional<double>& lately = took_ms_[at];
    lately = lately ? (1.0 - kBelief) * *lately + kBelief * milliseconds : milliseconds;
    if (at != at_) return;
    if (*lately > longest_ms_ && at_ + 1 < kDivisors.size()) {
        ++at_;
    } else if (at_ > 0 && expected_ms(at_ - 1) < kRoomToGrow * longest_ms_) {
        --at_;
    } else if (at_ > 0 && took_ms_[at_ - 1]) {
        // What was too slow once is tried again some time.
        took_ms_[at_ - 1] = *took_ms_[at_ - 1] * 0.995;
    }
}

void Pacer::forget() {
    took_ms_ = {};
    at_ = always_whole_ ? 0 : 1;
}

}  // namespace obscura::app::explorer
