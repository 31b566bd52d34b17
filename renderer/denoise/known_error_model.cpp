// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "renderer/denoise/denoise.h"
#include "renderer/denoise/weighted_mean.h"
#include "renderer/model/seen_buffers.h"

namespace obscura::renderer {
namespace {

/// Taps to each side.
int reach_of(int samples) { return samples < 4 ? 7 : 3; }

constexpr double kTolerance = 0.004;  // of the depth, for each pixel of distance

/// What a pass reads and writes of a pixel.
struct Moments {
    Rounded mean;
    Rounded square;
};

struct Surface {
    Rounded reciprocal;  ///< of the depth
    Rounded3 normal;
};

class MomentsPass {
  public:
    MomentsPass(const SeenBuffers& buffers, const std::vector<Surface>& surfaces,
                const std::vector<Moments>& from, int dx, int dy)
        : buffers_(buffers),
          surfaces_(surfaces),
          from_(from),
          reach_(reach_of(buffers.samples)),
          dx_(dx),
          dy_(dy) {}

    [[nodiscard]] Moments at(int x, int y) const {
        const Rounded& w = surface(x, y, 0).reciprocal;
        const Rounded before = w - surface(x, y, -1).reciprocal;
        const Rounded after = surface(x, y, 1).reciprocal - w;
        const bool first = abs(before).value < abs(after).value;
        const Moments nominal = along(x, y, first ? before : after);
        const bool either =
            first ? may_be_at_least(abs(before), abs(after)) : may_be_less(abs(before), abs(after));
        if (!either) return nominal;
        const Moments other = along(x, y, first ? after : before);
        const auto both = [](const Rounded& a, const Rounded& b) {
            return Rounded(a.value, std::max(a.error, std::abs(b.value - a.value) + b.error));
        };
        return {both(nominal.mean, other.mean), both(nominal.square, other.square)};
    }

  private:
    [[nodiscard]] const Surface& surface(int x, int y, int i) const {
        return surfaces_[buffers_.index(std::clamp(x + i * dx_, 0, buffers_.width - 1),
                                        std::clamp(y + i * dy_, 0, buffers_.height - 1))];
    }

    [[nodiscard]] Moments along(int x, int y, const Rounded& slope) const {
        const Surface& own = surface(x, y, 0);
        const Rounded per_tolerance = Rounded(1.0) / (nearest_float(kTolerance) * own.reciprocal);
        WeightedMean mean;
        WeightedMean square;
        for (int i = -reach_; i <= reach_; ++i) {
            const int at_x = x + i * dx_;
            const int at_y = y + i * dy_;
            if (at_x < 0 || at_x >= buffers_.width || at_y < 0 || at_y >= buffers_.height) continue;
            const double most = reach_ + 1.0 - std::abs(i);
            Rounded weight(most);
            if (i != 0) {
                const Surface& tap = surface(x, y, i);
                const Rounded off = (tap.reciprocal - (own.reciprocal + slope * Rounded(i))) *
                                    (per_tolerance / Rounded(std::abs(i)));
                const Rounded turn = max(dot(tap.normal, own.normal), Rounded(0.0));
                const Rounded squared = turn * turn;
                weight =
                    Rounded(most) * max(Rounded(0.0), Rounded(1.0) - off * off) * squared * squared;
            }
            const Moments& tap = from_[buffers_.index(at_x, at_y)];
            mean.add(weight, tap.mean, most);
            square.add(weight, tap.square, most);
        }
        return {mean.mean(reach_ + 1.0), square.mean(reach_ + 1.0)};
    }

    const SeenBuffers& buffers_;
    const std::vector<Surface>& surfaces_;
    const std::vector<Moments>& from_;
    int reach_;
    int dx_;
    int dy_;
};

/// The mean, and of the pixel's own value as much as the samples' error does not explain.
Admitted mixed(const Moments& around, const Rounded& own, int samples) {
    const Rounded zero(0.0);
    const Rounded one(1.0);
    const Rounded variance = max(around.square - around.mean * around.mean, zero);
    const Rounded count(std::max(samples, 1));
    const Rounded noise = around.mean * max(one - around.mean, zero) / (count * sqrt(count));
    Rounded share = max(variance - noise, zero) / max(variance, nearest_float(1.0e-9));
    share = between(std::clamp(share.value, 0.0, 1.0), std::clamp(share.low(), 0.0, 1.0),
                    std::clamp(share.high(), 0.0, 1.0));
    const Rounded caution(std::min(count.value / 24.0, 1.0));
    Rounded kept = share * (one + caution * (one - share));
    kept = between(std::clamp(kept.value, 0.0, 1.0), std::clamp(kept.low(), 0.0, 1.0),
                   std::clamp(kept.high(), 0.0, 1.0));
    const Rounded value = around.mean * (one - kept) + own * kept;
    const double off =
        std::abs(own.value - around.mean.value) * kept.error + around.mean.error + 4.0 * kUlp;
    return {value.value, value.value - off, value.value + off};
}

}  // namespace

std::vector<Admitted> known_error_model(const SeenBuffers& buffers,
                                        std::span<const float> accessibility) {
    const SeenView view(buffers);
    std::vector<Surface> surfaces(accessibility.size());
    for (int y = 0; y < buffers.height; ++y) {
        for (int x = 0; x < buffers.width; ++x) {
            surfaces[buffers.index(x, y)] = {
                Rounded(1.0) / max(Rounded(buffers.depth_at(x, y)), nearest_float(1.0e-9)),
                view.normal(x, y)};
        }
    }
    std::vector<Moments> moments;
    for (const float own : accessibility)
        moments.push_back({Rounded(own), Rounded(own) * Rounded(own)});
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}}) {
        const MomentsPass pass(buffers, surfaces, moments, dx, dy);
        std::vector<Moments> to(moments.size(), {Rounded(1.0), Rounded(1.0)});
        for (int y = 0; y < buffers.height; ++y) {
            for (int x = 0; x < buffers.width; ++x) {
                if (!buffers.is_empty(x, y)) to[buffers.index(x, y)] = pass.at(x, y);
            }
        }
        moments = std::move(to);
    }
    std::vector<Admitted> image(accessibility.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (buffers.empty[i] == 0) {
            image[i] = mixed(moments[i], Rounded(accessibility[i]), buffers.samples);
        }
    }
    return image;
}

}  // namespace obscura::renderer
