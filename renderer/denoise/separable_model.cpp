// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/denoise/denoise.h"
#include "renderer/model/seen_buffers.h"

namespace obscura::renderer {
namespace {

constexpr int kReach = 3;             // taps to each side
constexpr double kTolerance = 0.004;  // of the depth, for each pixel of distance

struct Direction {
    int x;
    int y;
};

Rounded reciprocal_depth(const SeenBuffers& buffers, int x, int y) {
    const float depth_m =
        buffers.depth_at(std::clamp(x, 0, buffers.width - 1), std::clamp(y, 0, buffers.height - 1));
    return Rounded(1.0) / max(Rounded(depth_m), nearest_float(1.0e-9));
}

/// One pixel of one pass.
class Tap {
  public:
    Tap(const SeenBuffers& buffers, const std::vector<Rounded>& from, int x, int y,
        Direction direction)
        : w_(reciprocal_depth(buffers, x, y)) {
        for (int i = -kReach; i <= kReach; ++i) {
            const int at_x = x + direction.x * i;
            const int at_y = y + direction.y * i;
            const auto slot = static_cast<std::size_t>(i + kReach);
            depth_[slot] = reciprocal_depth(buffers, at_x, at_y);
            inside_[slot] = at_x >= 0 && at_x < buffers.width && at_y >= 0 && at_y < buffers.height;
            if (inside_[slot]) value_[slot] = from[buffers.index(at_x, at_y)];
        }
    }

    /// The mean for the slope that the definition takes, and for the other where rounding may
    /// prefer that.
    [[nodiscard]] Rounded mean() const {
        const Rounded before = w_ - depth_[kReach - 1];
        const Rounded after = depth_[kReach + 1] - w_;
        const bool first = abs(before).value < abs(after).value;
        const Rounded nominal = mean_along(first ? before : after);
        const bool either =
            first ? may_be_at_least(abs(before), abs(after)) : may_be_less(abs(before), abs(after));
        if (!either) return nominal;
        const Rounded other = mean_along(first ? after : before);
        return {nominal.value,
                std::max(nominal.error, std::abs(other.value - nominal.value) + other.error)};
    }

  private:
    [[nodiscard]] Rounded weight(int i, const Rounded& slope) const {
        if (i == 0) return Rounded(4.0);
        const Rounded distance_px(std::abs(i));
        const Rounded per_tolerance = Rounded(1.0) / (nearest_float(kTolerance) * w_);
        const Rounded off =
            (depth_[static_cast<std::size_t>(i + kReach)] - (w_ + slope * Rounded(i))) *
            (per_tolerance / distance_px);
        return (Rounded(4.0) - distance_px) * max(Rounded(0.0), Rounded(1.0) - off * off);
    }

    [[nodiscard]] Rounded mean_along(const Rounded& slope) const {
        std::array<Rounded, 2 * kReach + 1> weights{};
        double sum = 0.0;
        double total = 0.0;
        for (int i = -kReach; i <= kReach; ++i) {
            const auto slot = static_cast<std::size_t>(i + kReach);
            if (!inside_[slot]) continue;
            weights[slot] = weight(i, slope);
            sum += weights[slot].value * value_[slot].value;
            total += weights[slot].value;
        }
        const double mean = sum / total;
        // An error of a weight, which is between 0 and 4, moves the mean by the tap's distance from
        // it; the pixel's own weight is 4 in any case.
        double error = 0.0;
        for (std::size_t slot = 0; slot < weights.size(); ++slot) {
            if (!inside_[slot]) continue;
            const double weight_error = std::min(weights[slot].error, 4.0);
            error += weight_error * std::abs(value_[slot].value - mean) /
                         std::max(total - weight_error, 4.0) +
                     weights[slot].value * value_[slot].error / total;
        }
        constexpr int kOperations = 2 * (2 * kReach + 1) + 3;
        return {mean, error + kOperations * kUlp * mean};
    }

    Rounded w_;
    std::array<Rounded, 2 * kReach + 1> depth_;
    std::array<Rounded, 2 * kReach + 1> value_;
    std::array<bool, 2 * kReach + 1> inside_{};
};

std::vector<Rounded> pass(const SeenBuffers& buffers, const std::vector<Rounded>& from,
                          Direction direction) {
    std::vector<Rounded> to(from.size(), Rounded(1.0));
    for (int y = 0; y < buffers.height; ++y) {
        for (int x = 0; x < buffers.width; ++x) {
            if (buffers.is_empty(x, y)) continue;
            to[buffers.index(x, y)] = Tap(buffers, from, x, y, direction).mean();
        }
    }
    return to;
}

}  // namespace

std::vector<Admitted> separable_model(const SeenBuffers& buffers,
                                      std::span<const float> accessibility) {
    std::vector<Rounded> values(accessibility.begin(), accessibility.end());
    values = pass(buffers, values, {1, 0});
    values = pass(buffers, values, {0, 1});
    std::vector<Admitted> image;
    image.reserve(values.size());
    for (const Rounded& value : values) image.push_back({value.value, value.low(), value.high()});
    return image;
}

}  // namespace obscura::renderer
