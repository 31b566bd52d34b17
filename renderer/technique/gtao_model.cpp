// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/gtao.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/slices_model.h"

namespace obscura::renderer {
namespace {

class GtaoModel {
  public:
    GtaoModel(const SeenBuffers& buffers, const Variant& variant)
        : march_(buffers), clamped_(!variant.unclamped) {
        const Technique& technique = *find_technique(variant.technique);
        const auto value = [&](const char* name) {
            return nearest_float(variant.value_of(*technique.find_parameter(name)));
        };
        radius_m_ = value("radius_m") * value("reach");
        falloff_ = value("falloff");
        thin_ = variant.value_of(*technique.find_parameter("thin_occluder"));
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
            visible += arc_of(p.facing, s.across, horizon(p, s, 1.0, turn, -s.sine));
            visible += arc_of(p.facing, -s.across, horizon(p, s, -1.0, turn, s.sine));
            open += arc_of(p.facing, s.across, bounds_of(-s.sine));
            open += arc_of(p.facing, -s.across, bounds_of(s.sine));
        }
        Bounded mean{visible.value / open.value, std::max(visible.low, 0.0) / open.high,
                     open.low > 0.0 ? visible.high / open.low : 1.0};
        if (clamped_) {
            for (double* end : {&mean.value, &mean.low, &mean.high}) {
                *end = std::clamp(*end, 0.0, 1.0);
            }
        }
        const Bounded found = power_of(mean, power_);
        return {found.value, found.low, found.high,
                2 * steps_ * static_cast<int>(directions_.size())};
    }

  private:
    [[nodiscard]] Bounded horizon(const SliceSurface& p, const SlicePlane& s, double side,
                                  const Turn& turn, const Rounded& open) const {
        const Rounded radius_px = radius_m_ / (p.z * p.pixel);
        Bounded found = bounds_of(open);
        for (int i = 0; i < steps_; ++i) {
            const Rounded distance_px = slice_distance_px(i, steps_, turn, radius_px, spread_);
            const SliceSamples seen = march_.samples(p, s, Rounded(side) * distance_px);
            const Rounded nominal = cosine_of(seen.front(), open);
            Bounded cosine = bounds_of(nominal);
            for (const SliceSample& other : seen) {
                const Rounded may_be = cosine_of(other, open);
                cosine.low = std::min(cosine.low, may_be.low());
                cosine.high = std::max(cosine.high, may_be.high());
            }
            const auto raise = [this](double& before, double to, double rounding) {
                before = std::max(to, before + thin_ * (to - before)) + rounding;
            };
            raise(found.value, cosine.value, 0.0);
            raise(found.low, cosine.low, -4.0 * kUlp);
            raise(found.high, cosine.high, 4.0 * kUlp);
        }
        return found;
    }

    /// Of the horizon that a sample makes: less than its own where it is far.
    [[nodiscard]] Rounded cosine_of(const SliceSample& sample, const Rounded& open) const {
        if (!sample.seen) return open;
        if (!sample.known) return between(open.value, open.low(), 1.0 + kUlp);
        const Rounded per_m = Rounded(1.0) / max(radius_m_ * falloff_, nearest_float(1.0e-30));
        const Rounded weight =
            clamp((radius_m_ - sqrt(sample.squared)) * per_m, Rounded(0.0), Rounded(1.0));
        return open + weight * (max(sample.cosine, open) - open);
    }

    SlicesModel march_;
    Rounded radius_m_;
    Rounded falloff_;
    double thin_ = 0.0;
    Rounded spread_;
    Rounded power_;
    bool clamped_;
    Tile<Turn> tile_;
    int steps_ = 4;
    std::vector<Turn> directions_;
};

}  // namespace

PixelModel gtao_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const GtaoModel>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
