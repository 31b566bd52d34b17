// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/bitmask.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/slices_model.h"

namespace obscura::renderer {
namespace {

constexpr int kSectors = 32;

/// Sectors from one place of the slice to another, both counted in sectors.
std::uint32_t sectors_between(double from, double to) {
    std::uint32_t mask = 0;
    const auto first = static_cast<int>(std::floor(std::clamp<double>(from, 0, kSectors)));
    const auto end = static_cast<int>(std::floor(std::clamp<double>(to, 0, kSectors)));
    for (int i = first; i < end; ++i) mask |= std::uint32_t{1} << i;
    return mask;
}

/// Hidden sectors: where nothing is rounded, in any case, and perhaps.
struct Hidden {
    std::uint32_t nominal = 0;
    std::uint32_t certain = 0;
    std::uint32_t possible = 0;

    void operator|=(const Hidden& other) {
        nominal |= other.nominal;
        certain |= other.certain;
        possible |= other.possible;
    }
};

/// One side of a slice.
struct Side {
    double sign;
    Rounded open;     ///< cosine of the tangent plane
    Rounded across;   ///< of the normal
    Rounded middle;   ///< place of the ray to the camera, in sectors
    Rounded per_arc;  ///< sectors
};

class BitmaskModel {
  public:
    BitmaskModel(const SeenBuffers& buffers, const Variant& variant)
        : march_(buffers), clamped_(!variant.unclamped) {
        const Technique& technique = *find_technique(variant.technique);
        const auto value = [&](const char* name) {
            return nearest_float(variant.value_of(*technique.find_parameter(name)));
        };
        const Rounded radius_m = value("radius_m");
        reach_m_ = radius_m * value("reach");
        farthest_m_ = radius_m * value("cut_off");
        thickness_m_ = {radius_m * value("thickness")};
        if (technique.find_parameter("second_thickness") != nullptr) {
            thickness_m_.push_back(radius_m * value("second_thickness"));
        }
        spread_ = value("step_spread");
        power_ = value("power");
        const Fan fan = fan_of_slices(variant);
        tile_ = turn_tile(fan.sector_rad, variant.noise);
        steps_ = fan.steps;
        directions_ = part_of(fan_turns(fan), variant);
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const SliceSurface p = march_.surface(x, y);
        const Turn& turn = tile_.at(x, y);
        Bounded visible;
        Bounded open;
        for (const Turn& by : directions_) {
            const SlicePlane s = march_.slice(p, turn, by);
            const Rounded after = rounded(arc_of(p.facing, s.across, bounds_of(-s.sine)));
            const Rounded before = rounded(arc_of(p.facing, -s.across, bounds_of(s.sine)));
            const Rounded whole = after + before;
            const Rounded per_arc = Rounded(kSectors) / whole;
            const Rounded middle = before * per_arc;
            Hidden hidden = hidden_on(p, s, turn, {1.0, -s.sine, s.across, middle, per_arc});
            hidden |= hidden_on(p, s, turn, {-1.0, s.sine, -s.across, middle, -per_arc});
            const auto share = [](std::uint32_t mask) {
                return 1.0 - std::popcount(mask) / static_cast<double>(kSectors);
            };
            visible += {whole.value * share(hidden.nominal), whole.value * share(hidden.possible),
                        whole.value * share(hidden.certain)};
            open += {whole.value, whole.low(), whole.high()};
        }
        // Both sums have the same factors: their errors move the share by no more than this.
        const double rounding = 2.0 * (open.high - open.low) / open.value + 8.0 * kUlp;
        const auto mean_of = [&](double sum, double by) {
            const double mean = sum / open.value + by;
            return clamped_ ? std::clamp(mean, 0.0, 1.0) : std::max(mean, 0.0);
        };
        const Bounded found =
            power_of({mean_of(visible.value, 0.0), mean_of(visible.low, -rounding),
                      mean_of(visible.high, rounding)},
                     power_);
        return {found.value, found.low, found.high,
                2 * steps_ * static_cast<int>(directions_.size() * thickness_m_.size())};
    }

  private:
    [[nodiscard]] static Rounded rounded(const Bounded& a) {
        return between(a.value, a.low, a.high);
    }

    [[nodiscard]] Hidden hidden_on(const SliceSurface& p, const SlicePlane& s, const Turn& turn,
                                   const Side& side) const {
        const Rounded radius_px = reach_m_ / (p.z * p.pixel);
        Hidden hidden;
        for (int i = 0; i < steps_; ++i) {
            const Rounded distance_px =
                Rounded(side.sign) * slice_distance_px(i, steps_, turn, radius_px, spread_);
            for (std::size_t layer = 0; layer < thickness_m_.size(); ++layer) {
                const SliceSamples seen = march_.samples(p, s, distance_px, layer > 0);
                const auto hides = [&](const SliceSample& sample) {
                    return hidden_by(p, s, turn, side, distance_px, sample, thickness_m_[layer]);
                };
                Hidden found = hides(seen.front());
                for (const SliceSample& other : seen) {
                    const Hidden may_be = hides(other);
                    found.certain &= may_be.certain;
                    found.possible |= may_be.possible;
                }
                hidden |= found;
            }
        }
        return hidden;
    }

    [[nodiscard]] Hidden hidden_by(const SliceSurface& p, const SlicePlane& s, const Turn& turn,
                                   const Side& side, const Rounded& distance_px,
                                   const SliceSample& sample, const Rounded& thickness_m) const {
        Hidden hidden;
        if (!sample.seen) return hidden;
        if (!sample.known) {
            hidden.possible = ~std::uint32_t{0};
            return hidden;
        }
        const Rounded limit = farthest_m_ * farthest_m_;
        if (!may_be_at_least(limit, sample.squared)) return hidden;
        const Rounded front = place_of(p, turn, side, sample);
        const Rounded back =
            place_of(p, turn, side, SlicesModel::moved(p, s, distance_px, sample, thickness_m));
        const Rounded from = min(front, back);
        const Rounded to = max(front, back);
        hidden.possible = sectors_between(from.low(), to.high());
        if (!may_be_less(limit, sample.squared)) {
            hidden.certain = sectors_between(from.high(), to.low());
        }
        if (sample.squared.value <= limit.value) {
            hidden.nominal = sectors_between(from.value, to.value);
        }
        return hidden;
    }

    /// Of an angle's cosine, in sectors.
    [[nodiscard]] static Rounded place_of(const SliceSurface& p, const Turn& turn, const Side& side,
                                          const SliceSample& sample) {
        const Rounded cosine = max(sample.cosine, side.open);
        const Rounded arc = rounded(arc_of(p.facing, side.across, bounds_of(cosine)));
        return side.middle + arc * side.per_arc + Rounded(turn.jitter);
    }

    SlicesModel march_;
    Rounded reach_m_;
    Rounded farthest_m_;
    std::vector<Rounded> thickness_m_;  ///< of each layer
    Rounded spread_;
    Rounded power_;
    bool clamped_;
    Tile<Turn> tile_;
    int steps_ = 4;
    std::vector<Turn> directions_;
};

}  // namespace

PixelModel bitmask_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const BitmaskModel>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
