// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "renderer/model/seen_buffers.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/view_space.h"

namespace obscura::renderer {
namespace {

/// The artistic variables, as the shader's floats.
struct Curve {
    Rounded radius_m;
    Rounded full_m;
    Rounded no_m;
    Rounded scale_per_m;
    Rounded power;

    explicit Curve(const Variant& variant) {
        const Technique& technique = *find_technique(variant.technique);
        const auto value = [&](const char* name) {
            return nearest_float(variant.value_of(*technique.find_parameter(name)));
        };
        radius_m = value("radius_m");
        full_m = value("full_threshold_m");
        no_m = value("no_threshold_m");
        scale_per_m = value("depth_scale_per_m");
        power = value("power");
    }

    /// Accessibility of a sample with that depth difference, between the thresholds.
    [[nodiscard]] Rounded accessibility(const Rounded& delta_m) const {
        const Rounded scaled = delta_m * scale_per_m;
        return pow(Rounded(1.0) / (Rounded(1.0) + scaled * scaled), power);
    }
};

/// What samples may be worth.
struct Worth {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
    int reads = 0;

    void admit(double least, double most) {
        low = std::min(low, least);
        high = std::max(high, most);
    }
    void admit(const Worth& other) { admit(other.low, other.high); }
    void operator+=(const Worth& other) {
        value += other.value;
        low += other.low;
        high += other.high;
        reads += other.reads;
    }
    static Worth nothing_yet() { return {0.0, 1.0, 0.0, 0}; }
};

class ViewSpaceModel {
  public:
    ViewSpaceModel(const SeenBuffers& buffers, const Variant& variant, int steps)
        : buffers_(buffers),
          view_(buffers),
          curve_(variant),
          samples_(samples_of_frame(variant)),
          steps_(steps) {
        const auto vector = [](const glm::vec3& v) {
            return Rounded3{Rounded(v.x), Rounded(v.y), Rounded(v.z)};
        };
        const Tile<glm::vec3> tile = rotation_tile(variant.noise);
        directions_.size = tile.size;
        for (const glm::vec3& r : tile) {
            std::vector<Rounded3>& directions = directions_.values.emplace_back();
            for (const glm::vec3& point : part_of(ball_kernel(variant.samples), variant)) {
                directions.push_back(reflect(vector(point), vector(r)));
            }
        }
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const Rounded z(buffers_.depth_at(x, y));
        const Rounded3 p = view_.point(x, y);
        const Rounded3 n = view_.normal(x, y);
        Worth sum;
        for (const Rounded3& direction : directions_.at(x, y)) {
            sum += sample(p, n, direction, z);
        }
        const double rounding = (samples_ + 3) * kUlp;
        return {sum.value / samples_, sum.low / samples_ * (1.0 - rounding),
                sum.high / samples_ * (1.0 + rounding), sum.reads};
    }

  private:
    /// Turned over where it points below the surface; either way where rounding decides.
    [[nodiscard]] Worth sample(const Rounded3& p, const Rounded3& n, const Rounded3& direction,
                               const Rounded& z) const {
        const Rounded above = dot(direction, n);
        const bool turned = above.value < 0.0;
        Worth worth = march(p, (turned ? -direction : direction) * curve_.radius_m, z);
        const bool either =
            turned ? may_be_at_least(above, Rounded(0.0)) : may_be_less(above, Rounded(0.0));
        if (either) worth.admit(march(p, (turned ? direction : -direction) * curve_.radius_m, z));
        return worth;
    }

    /// The first of the equal steps along the offset that finds an occluder counts.
    [[nodiscard]] Worth march(const Rounded3& p, const Rounded3& offset_m, const Rounded& z) const {
        const Rounded steps(steps_);
        const Rounded3 step_m{offset_m.x / steps, offset_m.y / steps, offset_m.z / steps};
        Worth worth = Worth::nothing_yet();
        bool found = false;
        bool may_go_on = true;
        for (int k = 1; k <= steps_ && may_go_on; ++k) {
            const SeenDepths seen = view_.depths_at(p + step_m * Rounded(k));
            if (!found) {
                ++worth.reads;
                const double delta_m = std::max(0.0, z.value - seen.nominal_m);
                found = delta_m >= curve_.full_m.value;
                if (found) worth.value = nominal(delta_m);
            }
            may_go_on = seen.any;
            if (seen.any) worth.admit(0.0, 1.0);
            for (const float seen_m : seen.all_m()) {
                const Rounded delta_m = max(Rounded(0.0), z - Rounded(seen_m));
                may_go_on |= may_be_less(delta_m, curve_.full_m);
                if (may_be_at_least(delta_m, curve_.full_m)) admit_occluder(delta_m, worth);
            }
        }
        if (may_go_on) worth.admit(1.0, 1.0);
        if (!found) worth.value = 1.0;
        return worth;
    }

    [[nodiscard]] double nominal(double delta_m) const {
        if (delta_m > curve_.no_m.value) return 1.0;
        const double scaled = delta_m * curve_.scale_per_m.value;
        return std::pow(1.0 / (1.0 + scaled * scaled), curve_.power.value);
    }

    void admit_occluder(const Rounded& delta_m, Worth& worth) const {
        if (may_be_less(curve_.no_m, delta_m)) worth.admit(1.0, 1.0);
        if (!may_be_at_least(curve_.no_m, delta_m)) return;
        const Rounded open = curve_.accessibility(delta_m);
        // Where nothing is known of it, it is still between 0 and 1.
        const bool known = std::isfinite(open.error);
        worth.admit(known ? std::max(0.0, open.low()) : 0.0, known ? open.high() : 1.0);
    }

    const SeenBuffers& buffers_;
    SeenView view_;
    Curve curve_;
    int samples_;
    int steps_;
    Tile<std::vector<Rounded3>> directions_;
};

}  // namespace

Model view_space_model(int steps) {
    return [steps](const SeenBuffers& buffers, const Variant& variant) -> PixelModel {
        return [model = std::make_shared<const ViewSpaceModel>(buffers, variant, steps)](
                   int x, int y) { return model->at(x, y); };
    };
}

}  // namespace obscura::renderer
