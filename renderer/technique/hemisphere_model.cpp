// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/hemisphere.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/point_model.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"

namespace obscura::renderer {
namespace {

Rounded3 rounded(const glm::vec3& v) { return {Rounded(v.x), Rounded(v.y), Rounded(v.z)}; }

Rounded3 cross(const Rounded3& a, const Rounded3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Three columns.
struct Frame3 {
    Rounded3 x;
    Rounded3 y;
    Rounded3 z;

    [[nodiscard]] Rounded3 operator*(const Rounded3& v) const {
        return x * v.x + y * v.y + z * v.z;
    }
};

/// technique/rotation.glsl; nothing where rounding decides.
std::optional<Frame3> rotation_to(const Rounded3& r) {
    const bool front = r.z.value >= 0.0;
    if (front ? may_be_less(r.z, Rounded(0.0)) : may_be_at_least(r.z, Rounded(0.0))) return {};
    const Rounded s(front ? 1.0 : -1.0);
    const Rounded a = Rounded(-1.0) / (s + r.z);
    const Rounded b = r.x * r.y * a;
    return Frame3{
        {Rounded(1.0) + s * r.x * r.x * a, s * b, -s * r.x}, {b, s + r.y * r.y * a, -r.y}, r};
}

/// technique/tangent_frame.glsl; nothing where rounding decides.
std::optional<Frame3> tangent_frame(const Rounded3& n, const Rounded3& r) {
    const Rounded3 t = r + n * -dot(r, n);
    const Rounded squared = dot(t, t);
    const Rounded least = nearest_float(4.0e-3);
    if (squared.value < least.value) {
        return may_be_at_least(squared, least) ? std::nullopt : rotation_to(n);
    }
    if (may_be_less(squared, least)) return {};
    const Rounded3 along = t * inverse_sqrt(squared);
    return Frame3{along, cross(n, along), n};
}

class HemisphereModel {
  public:
    HemisphereModel(const SeenBuffers& buffers, const Variant& variant)
        : buffers_(buffers), view_(buffers), tile_(rotation_tile(variant.noise)) {
        const Technique& technique = *find_technique(variant.technique);
        const auto value = [&](const char* name) {
            return variant.value_of(*technique.find_parameter(name));
        };
        radius_m_ = nearest_float(value("radius_m"));
        bias_m_ = nearest_float(value("bias")) * radius_m_;
        range_check_ = value("range_check") >= 0.5;
        power_ = nearest_float(value("power"));
        const auto kernel = hemisphere_kernel(variant.samples, value("shortest"));
        for (const glm::vec3& point : part_of(kernel, variant)) kernel_.push_back(rounded(point));
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const int reads = static_cast<int>(kernel_.size());
        const Rounded z(buffers_.depth_at(x, y));
        const Rounded3 p = view_.point(x, y);
        const glm::vec3& r = tile_.at(x, y);
        const std::optional<Frame3> frame = tangent_frame(view_.normal(x, y), rounded(r));
        if (!frame) return {0.5, 0.0, 1.0, reads};
        Bounded sum;
        for (const Rounded3& point : kernel_) sum += hidden(p + *frame * point * radius_m_, z);
        // Whole numbers are exact; the share and its distance from 1 are not.
        const double count = reads;
        const double rounding = 4.0 * kUlp;
        const Bounded mean{1.0 - sum.value / count, 1.0 - sum.high / count - rounding,
                           1.0 - sum.low / count + (sum.low > 0.0 ? rounding : 0.0)};
        const Bounded found = power_of(mean, power_);
        return {found.value, found.low, found.high, reads};
    }

  private:
    [[nodiscard]] Bounded hidden(const Rounded3& s, const Rounded& z) const {
        return worth_over(view_.depths_at(s), [&](const Rounded& there) {
            Bounded behind = if_less(bias_m_, -s.z - there);
            if (!range_check_) return behind;
            const Bounded far = if_less(radius_m_, abs(z - there));
            behind.value *= 1.0 - far.value;
            behind.low *= 1.0 - far.high;
            behind.high *= 1.0 - far.low;
            return behind;
        });
    }

    const SeenBuffers& buffers_;
    SeenView view_;
    Tile<glm::vec3> tile_;
    std::vector<Rounded3> kernel_;
    Rounded radius_m_;
    Rounded bias_m_;
    bool range_check_ = false;
    Rounded power_;
};

}  // namespace

PixelModel hemisphere_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const HemisphereModel>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
