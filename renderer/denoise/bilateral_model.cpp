// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "renderer/denoise/denoise.h"
#include "renderer/denoise/weighted_mean.h"
#include "renderer/model/seen_buffers.h"

namespace obscura::renderer {
namespace {

constexpr int kReach = 3;             // taps to each side
constexpr double kTolerance = 0.004;  // of the depth, for each pixel of distance

class Bilateral {
  public:
    Bilateral(const SeenBuffers& buffers, std::span<const float> accessibility)
        : buffers_(buffers), accessibility_(accessibility) {
        for (const float depth_m : buffers.depth_m) {
            reciprocal_.push_back(Rounded(1.0) / max(Rounded(depth_m), nearest_float(1.0e-9)));
        }
    }

    [[nodiscard]] Rounded at(int x, int y) const {
        const Rounded across = slope(x, y, 1, 0);
        const Rounded up = slope(x, y, 0, 1);
        const Rounded& w = reciprocal(x, y);
        const Rounded per_tolerance = Rounded(1.0) / (nearest_float(kTolerance) * w);
        WeightedMean mean;
        for (int j = -kReach; j <= kReach; ++j) {
            for (int i = -kReach; i <= kReach; ++i) {
                const int at_x = x + i;
                const int at_y = y + j;
                if (at_x < 0 || at_x >= buffers_.width || at_y < 0 || at_y >= buffers_.height) {
                    continue;
                }
                const double most = (4.0 - std::abs(i)) * (4.0 - std::abs(j));
                Rounded weight(most);
                if (i != 0 || j != 0) {
                    const Rounded plane = w + across * Rounded(i) + up * Rounded(j);
                    const Rounded off =
                        (reciprocal(at_x, at_y) - plane) *
                        (per_tolerance / Rounded(std::max(std::abs(i), std::abs(j))));
                    weight = Rounded(most) * max(Rounded(0.0), Rounded(1.0) - off * off);
                }
                mean.add(weight, Rounded(accessibility_[buffers_.index(at_x, at_y)]), most);
            }
        }
        return mean.mean(16.0);
    }

  private:
    [[nodiscard]] const Rounded& reciprocal(int x, int y) const {
        return reciprocal_[buffers_.index(std::clamp(x, 0, buffers_.width - 1),
                                          std::clamp(y, 0, buffers_.height - 1))];
    }

    /// The smaller of the two one-sided changes, or, where rounding decides, either.
    [[nodiscard]] Rounded slope(int x, int y, int dx, int dy) const {
        const Rounded before = reciprocal(x, y) - reciprocal(x - dx, y - dy);
        const Rounded after = reciprocal(x + dx, y + dy) - reciprocal(x, y);
        const bool first = abs(before).value < abs(after).value;
        const Rounded& nominal = first ? before : after;
        const bool either =
            first ? may_be_at_least(abs(before), abs(after)) : may_be_less(abs(before), abs(after));
        if (!either) return nominal;
        const Rounded& other = first ? after : before;
        return {nominal.value,
                std::max(nominal.error, std::abs(other.value - nominal.value) + other.error)};
    }

    const SeenBuffers& buffers_;
    std::span<const float> accessibility_;
    std::vector<Rounded> reciprocal_;
};

}  // namespace

std::vector<Admitted> bilateral_model(const SeenBuffers& buffers,
                                      std::span<const float> accessibility) {
    const Bilateral filter(buffers, accessibility);
    std::vector<Admitted> image(accessibility.size());
    for (int y = 0; y < buffers.height; ++y) {
        for (int x = 0; x < buffers.width; ++x) {
            if (buffers.is_empty(x, y)) continue;
            const Rounded value = filter.at(x, y);
            image[buffers.index(x, y)] = {value.value, value.low(), value.high()};
        }
    }
    return image;
}

}  // namespace obscura::renderer
