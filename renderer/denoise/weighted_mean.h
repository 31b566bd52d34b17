// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/model/rounded.h"

namespace obscura::renderer {

/// The mean of taps whose weights are rounded numbers: a filter's window in double precision.
class WeightedMean {
  public:
    /// `most`: the largest that the weight can be.
    void add(const Rounded& weight, const Rounded& value, double most) {
        sum_ += weight.value * value.value;
        total_ += weight.value;
        value_error_ += weight.value * value.error;
        const double error = std::min(weight.error, most);
        weight_error_ += error;
        low_ = std::min(low_, value.value);
        high_ = std::max(high_, value.value);
        ++taps_;
    }

    /// `own` is the least that all weights can add up to: the pixel's own.
    [[nodiscard]] Rounded mean(double own) const {
        const double mean = sum_ / total_;
        const double least = std::max(total_ - weight_error_, own);
        const double error = weight_error_ * (high_ - low_) / least + value_error_ / total_;
        return {mean, error + (2.0 * taps_ + 3.0) * kUlp * std::abs(mean)};
    }

  private:
    double sum_ = 0.0;
    double total_ = 0.0;
    double value_error_ = 0.0;
    double weight_error_ = 0.0;
    double low_ = INFINITY;
    double high_ = -INFINITY;
    int taps_ = 0;
};

}  // namespace obscura::renderer
