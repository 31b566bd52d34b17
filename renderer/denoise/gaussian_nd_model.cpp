// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/denoise/denoise.h"
#include "renderer/denoise/weighted_mean.h"
#include "renderer/model/seen_buffers.h"

namespace obscura::renderer {
namespace {

constexpr int kReach = 6;
constexpr double kDeviation_px = 2.0;
constexpr double kTolerance = 0.004;  // of the depth, for each pixel of distance
constexpr double kLeastCosine = 0.9;

struct Surface {
    Rounded reciprocal;  ///< of the depth
    Rounded3 normal;
};

class GaussianPass {
  public:
    GaussianPass(const SeenBuffers& buffers, const std::vector<Surface>& surfaces,
                 const std::vector<Rounded>& from, int dx, int dy)
        : buffers_(buffers), surfaces_(surfaces), from_(from), dx_(dx), dy_(dy) {}

    [[nodiscard]] Rounded at(int x, int y) const {
        const Rounded& w = surface(x, y, 0).reciprocal;
        const Rounded before = w - surface(x, y, -1).reciprocal;
        const Rounded after = surface(x, y, 1).reciprocal - w;
        const bool first = abs(before).value < abs(after).value;
        const Rounded nominal = along(x, y, first ? before : after);
        const bool either =
            first ? may_be_at_least(abs(before), abs(after)) : may_be_less(abs(before), abs(after));
        if (!either) return nominal;
        const Rounded other = along(x, y, first ? after : before);
        return {nominal.value,
                std::max(nominal.error, std::abs(other.value - nominal.value) + other.error)};
    }

  private:
    /// `i` pixels on, clamped to the image.
    [[nodiscard]] const Surface& surface(int x, int y, int i) const {
        return surfaces_[buffers_.index(std::clamp(x + i * dx_, 0, buffers_.width - 1),
                                        std::clamp(y + i * dy_, 0, buffers_.height - 1))];
    }

    [[nodiscard]] Rounded along(int x, int y, const Rounded& slope) const {
        const Surface& own = surface(x, y, 0);
        const Rounded& w = own.reciprocal;
        WeightedMean mean;
        for (int i = -kReach; i <= kReach; ++i) {
            const int at_x = x + i * dx_;
            const int at_y = y + i * dy_;
            if (at_x < 0 || at_x >= buffers_.width || at_y < 0 || at_y >= buffers_.height) continue;
            const double gauss = std::exp(-0.5 * i * i / (kDeviation_px * kDeviation_px));
            Rounded weight = i == 0 ? Rounded(1.0) : nearest_float(gauss);
            if (i != 0) {
                const Surface& tap = surface(x, y, i);
                const Rounded off = abs(tap.reciprocal - (w + slope * Rounded(i)));
                const Rounded most = nearest_float(kTolerance) * w * Rounded(std::abs(i));
                const Rounded cosine = dot(tap.normal, own.normal);
                const Rounded least = nearest_float(kLeastCosine);
                const bool is = off.value <= most.value && cosine.value >= least.value;
                const bool may_be = may_be_at_least(most, off) && may_be_at_least(cosine, least);
                const bool may_not = may_be_less(most, off) || may_be_less(cosine, least);
                if (!may_be) continue;
                if (!is) weight.value = 0.0;
                if (may_not) weight.error = gauss;
            }
            mean.add(weight, from_[buffers_.index(at_x, at_y)], gauss);
        }
        return mean.mean(1.0);
    }

    const SeenBuffers& buffers_;
    const std::vector<Surface>& surfaces_;
    const std::vector<Rounded>& from_;
    int dx_;
    int dy_;
};

}  // namespace

std::vector<Admitted> gaussian_nd_model(const SeenBuffers& buffers,
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
    std::vector<Rounded> values(accessibility.begin(), accessibility.end());
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}}) {
        const GaussianPass pass(buffers, surfaces, values, dx, dy);
        std::vector<Rounded> to(values.size(), Rounded(1.0));
        for (int y = 0; y < buffers.height; ++y) {
            for (int x = 0; x < buffers.width; ++x) {
                if (!buffers.is_empty(x, y)) to[buffers.index(x, y)] = pass.at(x, y);
            }
        }
        values = std::move(to);
    }
    std::vector<Admitted> image;
    image.reserve(values.size());
    for (const Rounded& value : values) image.push_back({value.value, value.low(), value.high()});
    return image;
}

}  // namespace obscura::renderer
