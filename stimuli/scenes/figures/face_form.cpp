// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "stimuli/scenes/figures/figure.h"

namespace obscura::stimuli::figures {
namespace {

/// The outline of a face at one height above the eyes, of a head 0.235 m high: two half ellipses
/// that meet where it is widest. Half its width, and the z of that place, of the front and of the
/// back, which is the jaw's edge below the ears.
struct Row {
    float y;
    glm::vec4 at;
};
constexpr std::array<Row, 17> kRows{{{0.082F, {0.054F, -0.004F, 0.0600F, -0.060F}},
                                     {0.066F, {0.0625F, 0.000F, 0.0735F, -0.060F}},
                                     {0.046F, {0.0665F, 0.003F, 0.0820F, -0.055F}},
                                     {0.030F, {0.0675F, 0.004F, 0.0855F, -0.050F}},
                                     {0.014F, {0.0675F, 0.004F, 0.0868F, -0.050F}},
                                     {0.000F, {0.0675F, 0.004F, 0.0848F, -0.050F}},
                                     {-0.016F, {0.0668F, 0.005F, 0.0850F, -0.046F}},
                                     {-0.032F, {0.0640F, 0.005F, 0.0868F, -0.040F}},
                                     {-0.048F, {0.0600F, 0.006F, 0.0885F, -0.028F}},
                                     {-0.060F, {0.0570F, 0.008F, 0.0895F, -0.016F}},
                                     {-0.072F, {0.0530F, 0.014F, 0.0885F, -0.002F}},
                                     {-0.084F, {0.0470F, 0.024F, 0.0865F, 0.014F}},
                                     {-0.096F, {0.0385F, 0.036F, 0.0865F, 0.029F}},
                                     {-0.106F, {0.0295F, 0.047F, 0.0855F, 0.041F}},
                                     {-0.114F, {0.0200F, 0.056F, 0.0800F, 0.051F}},
                                     {-0.119F, {0.0100F, 0.062F, 0.0720F, 0.059F}},
                                     {-0.1215F, {0.0020F, 0.065F, 0.0675F, 0.064F}}}};

/// A face without its features, as a solid: what brow, eyes, nose and mouth are modelled on.
class FaceForm final : public Shape {
  public:
    FaceForm(const Placed& at, float scale, const FaceTraits& traits) : at_(at), scale_(scale) {
        for (std::size_t i = 0; i < kSteps; ++i) {
            const float y = kLow + (kHigh - kLow) * static_cast<float>(i) / (kSteps - 1);
            table_[i] = row_at(y);
            // A jaw is wide or narrow from the cheekbones down.
            const float below = std::clamp((-0.020F - y) / 0.050F, 0.0F, 1.0F);
            table_[i].x *= 1.0F + (traits.jaw - 1.0F) * below;
        }
        const glm::vec3 middle = at_(0.0F, scale_ * 0.5F * (kLow + kHigh), 0.0F);
        bounds_.include(middle, scale_ * 0.145F);
    }

    [[nodiscard]] float distance(const glm::vec3& p) const override {
        const glm::vec3 q = ((p - at_.origin_m) * at_.axes) / scale_;
        const float y = std::clamp(q.y, kLow, kHigh);
        glm::vec4 row;
        glm::vec4 slope;
        row_and_slope(y, row, slope);
        const float dz = q.z - row.y;
        const bool before = dz > 0.0F;
        const float deep = std::max(before ? row.z - row.y : row.y - row.w, 0.002F);
        const float deep_slope = before ? slope.z - slope.y : slope.y - slope.w;
        const float tx = q.x / row.x;
        const float tz = dz / deep;
        const float f = tx * tx + tz * tz;
        glm::vec3 gradient(
            2.0F * tx / row.x,
            -2.0F * (tx * tx * slope.x / row.x + tz * (slope.y + tz * deep_slope) / deep),
            2.0F * tz / deep);
        // Where the outline shrinks fast the first order says too little far from the surface.
        const float level = 3.2F * std::sqrt(gradient.x * gradient.x + gradient.z * gradient.z);
        gradient.y = std::clamp(gradient.y, -level, level);
        const float steep = glm::length(gradient);
        const float root = std::sqrt(f);
        const float inside = steep < 1e-3F ? -deepest_of(row)
                                           : std::max(2.0F * (f - root) / steep, -deepest_of(row));
        const float outside_y = q.y - y;
        if (outside_y == 0.0F) return scale_ * inside;
        const float off = std::max(inside, 0.0F);
        return scale_ * (off > 0.0F ? std::sqrt(off * off + outside_y * outside_y)
                                    : std::max(inside, std::abs(outside_y)));
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override {
        const glm::vec3 q = glm::max(bounds_.low - p, p - bounds_.high);
        return glm::length(glm::max(q, glm::vec3(0.0F)));
    }
    [[nodiscard]] ShapeBounds bounds() const override { return bounds_; }

  private:
    static constexpr std::size_t kSteps = 96;
    static constexpr float kLow = -0.1215F;
    static constexpr float kHigh = 0.082F;

    /// Nowhere inside is it further to the surface: the jaw is thin behind its edge.
    static float deepest_of(const glm::vec4& row) {
        return std::max(std::min({0.7F * row.x, row.z - row.y, row.y - row.w}), 0.002F);
    }

    /// A spline through the rows whose slopes are those of the parabola through three of them.
    static glm::vec4 row_at(float y) {
        std::size_t i = 0;
        while (i + 2 < kRows.size() && y < kRows[i + 1].y) ++i;
        const auto slope_at = [](std::size_t k) {
            const std::size_t a = k == 0 ? 0 : k - 1;
            const std::size_t b = std::min(k + 1, kRows.size() - 1);
            if (a == k || b == k) return (kRows[b].at - kRows[a].at) / (kRows[b].y - kRows[a].y);
            const glm::vec4 up = (kRows[a].at - kRows[k].at) / (kRows[a].y - kRows[k].y);
            const glm::vec4 down = (kRows[k].at - kRows[b].at) / (kRows[k].y - kRows[b].y);
            const float share = (kRows[a].y - kRows[k].y) / (kRows[a].y - kRows[b].y);
            return glm::mix(up, down, share);
        };
        const float long_y = kRows[i + 1].y - kRows[i].y;
        const float t = std::clamp((y - kRows[i].y) / long_y, 0.0F, 1.0F);
        return hermite(kRows[i].at, slope_at(i) * long_y, kRows[i + 1].at, slope_at(i + 1) * long_y,
                       t);
    }
    static glm::vec4 hermite(const glm::vec4& a, const glm::vec4& slope_a, const glm::vec4& b,
                             const glm::vec4& slope_b, float t) {
        const float t2 = t * t;
        const float t3 = t2 * t;
        return a * (2.0F * t3 - 3.0F * t2 + 1.0F) + slope_a * (t3 - 2.0F * t2 + t) +
               b * (3.0F * t2 - 2.0F * t3) + slope_b * (t3 - t2);
    }

    /// From the table by cubics, so that the surface has no edges.
    void row_and_slope(float y, glm::vec4& row, glm::vec4& slope) const {
        constexpr float kStep = (kHigh - kLow) / (kSteps - 1);
        const float place = (y - kLow) / kStep;
        const auto i = std::min(static_cast<std::size_t>(place), kSteps - 2);
        const float t = place - static_cast<float>(i);
        const glm::vec4& a = table_[i];
        const glm::vec4& b = table_[i + 1];
        const glm::vec4 m0 = i == 0 ? b - a : 0.5F * (b - table_[i - 1]);
        const glm::vec4 m1 = i + 2 == kSteps ? b - a : 0.5F * (table_[i + 2] - a);
        row = hermite(a, m0, b, m1, t);
        const float t2 = t * t;
        slope = ((a - b) * (6.0F * t2 - 6.0F * t) + m0 * (3.0F * t2 - 4.0F * t + 1.0F) +
                 m1 * (3.0F * t2 - 2.0F * t)) /
                kStep;
    }

    Placed at_;
    float scale_;
    std::array<glm::vec4, kSteps> table_{};
    ShapeBounds bounds_;
};

}  // namespace

ShapePtr face_form(const Placed& at, float scale, const FaceTraits& traits) {
    return std::make_shared<FaceForm>(at, scale, traits);
}

}  // namespace obscura::stimuli::figures
