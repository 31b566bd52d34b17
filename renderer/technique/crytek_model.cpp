// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "renderer/model/seen_buffers.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/crytek.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {
namespace {

using Offsets = std::vector<Rounded3>;

/// The unit cube's corners, normalised, in rounds of eight; each offset 1 + 2.4/N times as long as
/// the one before. Turned so that +Z becomes r: the definition leaves the turn about r open, and
/// the shader's choice (Duff et al. 2017) is repeated here.
Offsets offsets_about(const glm::vec3& r, int samples, double offset_scale) {
    const Rounded x(r.x);
    const Rounded y(r.y);
    const Rounded z(r.z);
    const Rounded sign(r.z >= 0.0F ? 1.0 : -1.0);
    const Rounded a = Rounded(-1.0) / (sign + z);
    const Rounded b = x * y * a;
    const Rounded3 columns[3] = {{Rounded(1.0) + sign * x * x * a, sign * b, -sign * x},
                                 {b, sign + y * y * a, -y},
                                 {x, y, z}};
    const Rounded scale = nearest_float(offset_scale);
    double length = 1.0 / std::sqrt(3.0);
    Offsets offsets;
    for (int i = 0; i < samples; ++i) {
        length *= 1.0 + 2.4 / samples;
        const auto along = [&](int axis, int bit) {
            return columns[axis] * scale * nearest_float(((i >> bit) & 1) != 0 ? length : -length);
        };
        offsets.push_back(along(0, 2) + along(1, 1) + along(2, 0));
    }
    return offsets;
}

/// What one sample adds, from the depth that the buffer holds there.
Rounded visible_of(const Rounded& d, const Rounded& seen, bool farther) {
    const Rounded invalid = clamp(d - seen, Rounded(0.0), Rounded(1.0));
    return (farther ? Rounded(1.0) : Rounded(0.0)) * (Rounded(1.0) - invalid) +
           Rounded(0.5) * invalid;
}

class CrytekModel {
  public:
    CrytekModel(const SeenBuffers& buffers, const Variant& variant)
        : buffers_(buffers),
          view_(buffers),
          far_m_(buffers.camera.far_m),
          samples_(samples_of_frame(variant)),
          clamped_(!variant.unclamped) {
        const Parameter& scale = *find_technique(variant.technique)->find_parameter("offset_scale");
        const Tile<glm::vec3> tile = rotation_tile(variant.noise);
        offsets_.size = tile.size;
        for (const glm::vec3& r : tile) {
            const Offsets all = offsets_about(r, variant.samples, variant.value_of(scale));
            offsets_.values.push_back(part_of(all, variant, 8));
        }
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const ImagePoint place = view_.place_of(x, y);
        const Rounded d = Rounded(buffers_.depth_at(x, y)) / far_m_;
        Rounded sum;
        double low = 0.0;
        double high = 0.0;
        for (const Rounded3& offset : offsets_.at(x, y)) {
            const SeenDepths seen =
                view_.depths_at(ImagePoint{place.x + offset.x, place.y + offset.y});
            add(d, d + offset.z * d, seen, sum, low, high);
        }
        const Rounded count(samples_);
        const double rounding = samples_ * kUlp * high;
        Admitted found = curve(sum.value / samples_, (Rounded(low, rounding) / count).low(),
                               (Rounded(high, rounding) / count).high());
        found.depth_reads = samples_;
        return found;
    }

  private:
    void add(const Rounded& d, const Rounded& point_z, const SeenDepths& seen, Rounded& sum,
             double& low, double& high) const {
        const auto nominal = [&](float depth_m) {
            const double ds = static_cast<double>(depth_m) / far_m_.value;
            if (ds >= 1.0) return 1.0;
            return visible_of(Rounded(d.value), Rounded(ds), ds > point_z.value).value;
        };
        sum.value += nominal(seen.nominal_m);
        double least = seen.any ? 0.0 : 1.0;
        double most = seen.any ? 1.0 : 0.0;
        const auto admit = [&](const Rounded& value) {
            least = std::min(least, value.low());
            most = std::max(most, value.high());
        };
        for (const float depth_m : seen.all_m()) {
            const Rounded ds = Rounded(depth_m) / far_m_;
            if (may_be_at_least(ds, Rounded(1.0))) admit(Rounded(1.0));
            if (!may_be_less(ds, Rounded(1.0))) continue;
            if (may_be_less(point_z, ds)) admit(visible_of(d, ds, true));
            if (may_be_at_least(point_z, ds)) admit(visible_of(d, ds, false));
        }
        low += least;
        high += most;
    }

    /// a^2 + a, which rises where a is not negative.
    [[nodiscard]] Admitted curve(double nominal, double low, double high) const {
        const auto brightened = [this](double a) {
            const double value = a * a + a;
            return clamped_ ? std::clamp(value, 0.0, 1.0) : value;
        };
        return {brightened(nominal), brightened(low) * (1.0 - 2.0 * kUlp),
                brightened(high) * (1.0 + 2.0 * kUlp)};
    }

    const SeenBuffers& buffers_;
    SeenView view_;
    Rounded far_m_;
    int samples_;
    bool clamped_;
    Tile<Offsets> offsets_;
};

}  // namespace

PixelModel crytek_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const CrytekModel>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
