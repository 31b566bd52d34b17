// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/hbao.h"

#include <algorithm>
#include <memory>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/slices_model.h"

namespace obscura::renderer {
namespace {

/// Between what is found where nothing is rounded and all that may be.
Rounded widened(const Rounded& value, const Rounded& by) {
    return between(value.value, std::min(value.low(), by.low()), std::max(value.high(), by.high()));
}

class HbaoModel {
  public:
    HbaoModel(const SeenBuffers& buffers, const Variant& variant)
        : march_(buffers), clamped_(!variant.unclamped) {
        const Technique& technique = *find_technique(variant.technique);
        const auto value = [&](const char* name) {
            return nearest_float(variant.value_of(*technique.find_parameter(name)));
        };
        radius_m_ = value("radius_m") * value("reach");
        bias_ = value("bias");
        bias_cosine_ = sqrt(Rounded(1.0) - bias_ * bias_);
        spread_ = value("step_spread");
        strength_ = value("strength");
        power_ = value("power");
        const Fan fan = fan_of_directions(variant);
        tile_ = turn_tile(fan.sector_rad, variant.noise);
        steps_ = fan.steps;
        directions_ = part_of(fan_turns(fan), variant);
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const SliceSurface p = march_.surface(x, y);
        const Turn& turn = tile_.at(x, y);
        Rounded occluded;
        for (const Turn& by : directions_) {
            occluded = occluded + occluded_along(p, march_.slice(p, turn, by), turn);
        }
        const auto count = static_cast<int>(directions_.size());
        Bounded mean = bounds_of(Rounded(1.0) - strength_ * occluded / Rounded(count));
        if (clamped_) {
            for (double* end : {&mean.value, &mean.low, &mean.high}) {
                *end = std::clamp(*end, 0.0, 1.0);
            }
        }
        const Bounded found = power_of(mean, power_);
        return {found.value, found.low, found.high, steps_ * count};
    }

  private:
    struct State {
        Rounded horizon;
        Rounded occluded;
    };

    [[nodiscard]] Rounded occluded_along(const SliceSurface& p, const SlicePlane& s,
                                         const Turn& turn) const {
        const Rounded radius_px = radius_m_ / (p.z * p.pixel);
        const Rounded raised = s.cosine * bias_ - s.sine * bias_cosine_;
        // No higher than the ray to the camera; there both are 1 but for rounding.
        const bool below = -s.sine.value < bias_cosine_.value;
        State state{below ? raised : Rounded(1.0, raised.error), Rounded(0.0)};
        for (int i = 0; i < steps_; ++i) {
            const SliceSamples seen =
                march_.samples(p, s, slice_distance_px(i, steps_, turn, radius_px, spread_));
            State next = after(state, seen.front());
            for (const SliceSample& other : seen) {
                const State may_be = after(state, other);
                next.horizon = widened(next.horizon, may_be.horizon);
                next.occluded = widened(next.occluded, may_be.occluded);
            }
            state = next;
        }
        return state.occluded;
    }

    [[nodiscard]] State after(const State& before, const SliceSample& sample) const {
        if (!sample.seen) return before;
        if (!sample.known) {
            return {between(before.horizon.value, before.horizon.low(), 1.0),
                    between(before.occluded.value, before.occluded.low(),
                            before.occluded.high() + 2.0)};
        }
        const Rounded per_squared =
            Rounded(1.0) / max(radius_m_ * radius_m_, nearest_float(1.0e-30));
        const Rounded weight = max(Rounded(1.0) - sample.squared * per_squared, Rounded(0.0));
        State next = before;
        if (weight.high() > 0.0) {
            const Rounded raised = max(before.horizon, sample.cosine);
            const bool counts = weight.value > 0.0;
            // Where it may or may not be within reach, both are admitted.
            const Rounded& least = weight.low() > 0.0 ? raised : before.horizon;
            next.horizon = between(counts ? raised.value : before.horizon.value,
                                   std::min(least.low(), raised.low()), raised.high());
            next.occluded =
                before.occluded + weight * max(sample.cosine - before.horizon, Rounded(0.0));
        }
        return next;
    }

    SlicesModel march_;
    Rounded radius_m_;
    Rounded bias_;
    Rounded bias_cosine_;
    Rounded spread_;
    Rounded strength_;
    Rounded power_;
    bool clamped_;
    Tile<Turn> tile_;
    int steps_ = 4;
    std::vector<Turn> directions_;
};

}  // namespace

PixelModel hbao_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const HbaoModel>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
