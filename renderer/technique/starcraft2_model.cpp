// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/point_model.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/starcraft2.h"

namespace obscura::renderer {
namespace {

Rounded3 rounded(const glm::vec3& v) { return {Rounded(v.x), Rounded(v.y), Rounded(v.z)}; }

/// What samples see: every square of texels has the depth of one of them.
SeenBuffers with_squares(const SeenBuffers& buffers, int halvings) {
    SeenBuffers squares = buffers;
    const auto kept = [halvings](int at, int size) {
        return std::min(((at >> halvings) << halvings) + (1 << halvings) / 2, size - 1);
    };
    for (int y = 0; y < buffers.height; ++y) {
        for (int x = 0; x < buffers.width; ++x) {
            squares.depth_m[buffers.index(x, y)] =
                buffers.depth_at(kept(x, buffers.width), kept(y, buffers.height));
        }
    }
    return squares;
}

class Starcraft2Model {
  public:
    Starcraft2Model(const SeenBuffers& buffers, const Variant& variant)
        : buffers_(buffers),
          own_(buffers),
          samples_(with_squares(buffers, starcraft2_halvings(variant))),
          view_(samples_),
          points_(starcraft2_points(variant)),
          clamped_(!variant.unclamped) {
        const Technique& technique = *find_technique(variant.technique);
        const auto value = [&](const char* name) {
            return nearest_float(variant.value_of(*technique.find_parameter(name)));
        };
        radius_m_ = value("radius_m");
        small_radius_ = value("small_radius");
        epsilon_ = value("epsilon");
        full_ = value("full_threshold");
        no_ = value("no_threshold");
        power_ = value("power");
        small_power_ = value("small_power");
        footprint_ = value("footprint");
        const Tile<glm::vec3> tile = rotation_tile(variant.noise);
        tile_.size = tile.size;
        for (const glm::vec3& r : tile) tile_.values.push_back(rounded(r));
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const Rounded z(buffers_.depth_at(x, y));
        const Place place{own_.point(x, y), own_.normal(x, y), tile_.at(x, y)};
        const Rounded height = view_.pixel() * Rounded(buffers_.height);
        Rounded radius_m = min(radius_m_, footprint_ * height * z);
        Bounded occluded = occlusion_of(points_.wide, place, radius_m, power_);
        if (!points_.small.empty()) {
            radius_m = radius_m * small_radius_;
            const Bounded small = occlusion_of(points_.small, place, radius_m, small_power_);
            occluded = {std::max(occluded.value, small.value), std::max(occluded.low, small.low),
                        std::max(occluded.high, small.high)};
        }
        const auto end = [this](double open) {
            return clamped_ ? std::clamp(open, 0.0, 1.0) : open;
        };
        const int reads = static_cast<int>(points_.wide.size() + points_.small.size());
        return {end(1.0 - occluded.value), end(1.0 - occluded.high - kUlp),
                end(1.0 - occluded.low + (occluded.low > 0.0 ? kUlp : 0.0)), reads};
    }

  private:
    struct Place {
        Rounded3 p;
        Rounded3 n;
        Rounded3 r;
    };

    [[nodiscard]] Bounded occlusion_of(const std::vector<WeightedPoint>& points, const Place& place,
                                       const Rounded& radius_m, const Rounded& power) const {
        Bounded sum;
        for (const auto& [point, weight] : points) {
            const Rounded3 o = reflect(rounded(point), place.r);
            const Rounded above = dot(o, place.n);
            const bool turned = above.value < 0.0;
            const auto worth = [&](bool turn) {
                return sample(place.p + (turn ? -o : o) * radius_m, radius_m, power);
            };
            Bounded found = worth(turned);
            const bool either =
                turned ? may_be_at_least(above, Rounded(0.0)) : may_be_less(above, Rounded(0.0));
            if (either) {
                const Bounded other = worth(!turned);
                found.low = std::min(found.low, other.low);
                found.high = std::max(found.high, other.high);
            }
            sum += Bounded{weight * found.value, weight * found.low, weight * found.high};
        }
        // Of the weights, the products and the sum.
        const double rounding = (static_cast<double>(points.size()) + 3.0) * kUlp;
        sum.low -= rounding * std::abs(sum.low);
        sum.high += rounding * std::abs(sum.high);
        return sum;
    }

    [[nodiscard]] Bounded sample(const Rounded3& s, const Rounded& radius_m,
                                 const Rounded& power) const {
        return worth_over(view_.depths_at(s), [&](const Rounded& there) {
            const Rounded delta_m = -s.z - there;
            const Bounded counts = if_less(epsilon_ * radius_m, delta_m);
            if (counts.high == 0.0) return counts;
            Bounded found = curve(delta_m - full_ * radius_m, radius_m, power);
            found.value *= counts.value;
            if (counts.low == 0.0) found.low = 0.0;
            return found;
        });
    }

    /// What an occluder so far past the full threshold is worth.
    [[nodiscard]] Bounded curve(const Rounded& past_m, const Rounded& radius_m,
                                const Rounded& power) const {
        const Bounded whole = if_less(past_m, Rounded(0.0));
        if (whole.low == 1.0) return whole;
        const Rounded least = nearest_float(1.0e-9);
        const Rounded range_m = max((no_ - full_) * radius_m, nearest_float(1.0e-30));
        const Rounded share = past_m / range_m;
        Bounded found{0.0, 0.0, 1.0};
        if (std::isfinite(share.error)) {
            const Rounded open = pow(clamp(share, least, Rounded(1.0)), power);
            if (std::isfinite(open.error)) found = bounds_of(Rounded(1.0) - open);
        }
        const double exact =
            std::pow(std::clamp(past_m.value / range_m.value, least.value, 1.0), power.value);
        found.value = whole.value > 0.0 ? 1.0 : 1.0 - exact;
        found.low = std::min(found.low, found.value);
        found.high = std::max(found.high, found.value);
        if (whole.high == 1.0) found.high = 1.0;
        return found;
    }

    const SeenBuffers& buffers_;
    SeenView own_;  // the pixel itself, whose depth no square shares
    SeenBuffers samples_;
    SeenView view_;
    Starcraft2Points points_;
    bool clamped_;
    Tile<Rounded3> tile_;
    Rounded radius_m_;
    Rounded small_radius_;
    Rounded epsilon_;
    Rounded full_;
    Rounded no_;
    Rounded power_;
    Rounded small_power_;
    Rounded footprint_;
};

}  // namespace

PixelModel starcraft2_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const Starcraft2Model>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
