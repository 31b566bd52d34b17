// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/implicit_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace obscura::stimuli {
namespace {

float box_distance(const glm::vec3& local, const glm::vec3& half) {
    const glm::vec3 q = glm::abs(local) - half;
    return glm::length(glm::max(q, glm::vec3(0.0F))) +
           std::min(std::max(q.x, std::max(q.y, q.z)), 0.0F);
}

ShapeBounds bounds_of_box(const glm::vec3& centre, const glm::vec3& half, const glm::mat3& axes) {
    const glm::vec3 reach =
        glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z;
    return {centre - reach, centre + reach};
}

class RoundCone final : public Shape {
  public:
    RoundCone(const glm::vec3& a, float ra, const glm::vec3& b, float rb)
        : a_(a), b_(b), ra_(ra), rb_(rb), ba_(b - a), l2_(glm::dot(ba_, ba_)), rr_(ra - rb) {
        a2_ = l2_ - rr_ * rr_;
        swallowed_ = a2_ <= 1e-12F;  // one sphere holds the other
        il2_ = l2_ > 0.0F ? 1.0F / l2_ : 0.0F;
    }

    /// The three zones of the hull of two spheres: beside either end or beside the cone.
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        if (swallowed_) return std::min(glm::length(p - a_) - ra_, glm::length(p - b_) - rb_);
        const glm::vec3 pa = p - a_;
        const float y = glm::dot(pa, ba_);
        const float z = y - l2_;
        const glm::vec3 across = pa * l2_ - ba_ * y;
        const float x2 = glm::dot(across, across);
        const float y2 = y * y * l2_;
        const float z2 = z * z * l2_;
        const float k = (rr_ > 0.0F ? 1.0F : rr_ < 0.0F ? -1.0F : 0.0F) * rr_ * rr_ * x2;
        if ((z > 0.0F ? 1.0F : -1.0F) * a2_ * z2 > k) return std::sqrt(x2 + z2) * il2_ - rb_;
        if ((y > 0.0F ? 1.0F : -1.0F) * a2_ * y2 < k) return std::sqrt(x2 + y2) * il2_ - ra_;
        return (std::sqrt(x2 * a2_ * il2_) + y * rr_) * il2_ - ra_;
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override { return distance(p); }
    [[nodiscard]] ShapeBounds bounds() const override {
        ShapeBounds result;
        result.include(a_, ra_);
        result.include(b_, rb_);
        return result;
    }

  private:
    glm::vec3 a_, b_;
    float ra_, rb_;
    glm::vec3 ba_;
    float l2_, rr_, a2_ = 0.0F, il2_ = 0.0F;
    bool swallowed_ = false;
};

class Ellipsoid final : public Shape {
  public:
    Ellipsoid(const glm::vec3& centre, const glm::vec3& radii, const glm::mat3& axes)
        : centre_(centre), radii_(radii), axes_(axes) {}

    /// First-order distance f / |grad f| of the implicit function f = |p / radii| - 1.
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        const glm::vec3 q = ((p - centre_) * axes_) / radii_;
        const float k0 = glm::length(q);
        const float k1 = glm::length(q / radii_);
        const float deepest = -std::min(radii_.x, std::min(radii_.y, radii_.z));
        return k1 < 1e-6F ? deepest : std::max(k0 * (k0 - 1.0F) / k1, deepest);
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override {
        return box_distance((p - centre_) * axes_, radii_);
    }
    [[nodiscard]] ShapeBounds bounds() const override {
        return bounds_of_box(centre_, radii_, axes_);
    }

  private:
    glm::vec3 centre_, radii_;
    glm::mat3 axes_;
};

class RoundedBox final : public Shape {
  public:
    RoundedBox(const glm::vec3& centre, const glm::vec3& half, float rounding,
               const glm::mat3& axes)
        : centre_(centre), half_(half), rounding_(rounding), axes_(axes) {}
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        return box_distance((p - centre_) * axes_, half_ - rounding_) - rounding_;
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override { return distance(p); }
    [[nodiscard]] ShapeBounds bounds() const override {
        return bounds_of_box(centre_, half_, axes_);
    }

  private:
    glm::vec3 centre_, half_;
    float rounding_;
    glm::mat3 axes_;
};

class HalfSpace final : public Shape {
  public:
    HalfSpace(const glm::vec3& point, const glm::vec3& normal) : point_(point), normal_(normal) {}
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        return glm::dot(p - point_, normal_);
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override { return distance(p); }
    [[nodiscard]] ShapeBounds bounds() const override {
        return {glm::vec3(-1e9F), glm::vec3(1e9F)};
    }

  private:
    glm::vec3 point_, normal_;
};

class Grown final : public Shape {
  public:
    Grown(ShapePtr shape, float by) : shape_(std::move(shape)), by_(by) {}
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        return shape_->distance(p) - by_;
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override {
        return shape_->lower_bound(p) - by_;
    }
    [[nodiscard]] ShapeBounds bounds() const override {
        const ShapeBounds inner = shape_->bounds();
        return {inner.low - by_, inner.high + by_};
    }
    [[nodiscard]] ShapePtr restricted(const glm::vec3& p, float radius) const override {
        ShapePtr inner = shape_->restricted(p, radius + std::abs(by_));
        return inner ? std::make_shared<Grown>(std::move(inner), by_) : nullptr;
    }

  private:
    ShapePtr shape_;
    float by_;
};

class TubeSegment final : public Shape {
  public:
    TubeSegment(const CurvePoint& a, const CurvePoint& b, const TubeStyle& style)
        : a_(a), b_(b), ba_(b.position_m - a.position_m), style_(style) {
        inverse_length2_ = 1.0F / std::max(glm::dot(ba_, ba_), 1e-12F);
        direction_ = ba_ * std::sqrt(inverse_length2_);
        thick_ = std::max({a.width_m, a.height_m, b.width_m, b.height_m});
        round_ = a.width_m == a.height_m && b.width_m == b.height_m && !style.squarish;
    }

    [[nodiscard]] float distance(const glm::vec3& p) const override {
        return distance_below(p, std::numeric_limits<float>::max());
    }
    [[nodiscard]] float distance_below(const glm::vec3& p, float limit) const override {
        const glm::vec3 pa = p - a_.position_m;
        const float t = std::clamp(glm::dot(pa, ba_) * inverse_length2_, 0.0F, 1.0F);
        const glm::vec3 d = pa - ba_ * t;
        const float w = a_.width_m + (b_.width_m - a_.width_m) * t;
        const float length = glm::length(d);
        if (round_) return length - w;
        const float h = a_.height_m + (b_.height_m - a_.height_m) * t;
        // The squarish section reaches past the ellipse, at most by the fourth root of three.
        const float capsule = length - 1.32F * std::max(w, h);
        if (capsule >= limit) return capsule;
        return section(local(d, t), w, h);
    }
    [[nodiscard]] float relief(const glm::vec3& p) const override {
        if (!style_.relief) return 0.0F;
        const glm::vec3 pa = p - a_.position_m;
        const float t = std::clamp(glm::dot(pa, ba_) * inverse_length2_, 0.0F, 1.0F);
        const glm::vec3 at = local(pa - ba_ * t, t);
        const float w = a_.width_m + (b_.width_m - a_.width_m) * t;
        const float h = a_.height_m + (b_.height_m - a_.height_m) * t;
        return style_.relief({a_.length_m + (b_.length_m - a_.length_m) * t, std::atan2(at.y, at.x),
                              std::sqrt(w * h), p});
    }
    [[nodiscard]] float relief_high() const override { return style_.relief_high_m; }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override {
        const glm::vec3 pa = p - a_.position_m;
        const float t = std::clamp(glm::dot(pa, ba_) * inverse_length2_, 0.0F, 1.0F);
        return glm::length(pa - ba_ * t) - 1.32F * thick_ - style_.relief_high_m;
    }
    [[nodiscard]] ShapeBounds bounds() const override {
        ShapeBounds result;
        result.include(a_.position_m, 1.32F * thick_ + style_.relief_high_m);
        result.include(b_.position_m, 1.32F * thick_ + style_.relief_high_m);
        return result;
    }

  private:
    /// Along the normal, across it and along the axis.
    [[nodiscard]] glm::vec3 local(const glm::vec3& d, float t) const {
        const glm::vec3 mixed = a_.normal + (b_.normal - a_.normal) * t;
        const glm::vec3 normal = glm::normalize(mixed - direction_ * glm::dot(mixed, direction_));
        const glm::vec3 side = glm::cross(direction_, normal);
        return {glm::dot(d, normal), glm::dot(d, side), glm::dot(d, direction_)};
    }

    /// First-order distance to the (super)ellipse; beyond an end the section closes as a cap.
    [[nodiscard]] float section(const glm::vec3& at, float w, float h) const {
        const glm::vec3 radii(w, h, std::min(w, h));
        const glm::vec3 q = at / radii;
        if (style_.squarish) {
            const glm::vec3 q3 = q * q * q;
            const float k0 = std::sqrt(std::sqrt(glm::dot(q3, q)));
            const float k1 = glm::length(q3 / radii);
            if (k1 < 1e-9F) return -radii.z;
            return (k0 - 1.0F) * k0 * k0 * k0 / k1;
        }
        const float k0 = glm::length(q);
        const float k1 = glm::length(q / radii);
        if (k1 < 1e-6F) return -radii.z;
        return k0 * (k0 - 1.0F) / k1;
    }

    CurvePoint a_, b_;
    glm::vec3 ba_;
    TubeStyle style_;
    glm::vec3 direction_{0.0F};
    float inverse_length2_ = 0.0F;
    float thick_ = 0.0F;
    bool round_ = true;
};

glm::vec4 catmull_rom(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c,
                      const glm::vec4& d, float t) {
    return 0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * (t * t) +
                   (3.0F * b - a - 3.0F * c + d) * (t * t * t));
}

}  // namespace

void ShapeBounds::include(const glm::vec3& point_m, float radius_m) {
    low = glm::min(low, point_m - radius_m);
    high = glm::max(high, point_m + radius_m);
}

void ShapeBounds::include(const ShapeBounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
}

ShapePtr round_cone(const glm::vec3& a_m, float radius_a_m, const glm::vec3& b_m,
                    float radius_b_m) {
    return std::make_shared<RoundCone>(a_m, radius_a_m, b_m, radius_b_m);
}

ShapePtr ball(const glm::vec3& centre_m, float radius_m) {
    return ellipsoid(centre_m, glm::vec3(radius_m));
}

ShapePtr ellipsoid(const glm::vec3& centre_m, const glm::vec3& radii_m, const glm::mat3& axes) {
    return std::make_shared<Ellipsoid>(centre_m, radii_m, axes);
}

ShapePtr rounded_box(const glm::vec3& centre_m, const glm::vec3& half_m, float rounding_m,
                     const glm::mat3& axes) {
    return std::make_shared<RoundedBox>(centre_m, half_m, rounding_m, axes);
}

ShapePtr grown(ShapePtr shape, float by_m) {
    return std::make_shared<Grown>(std::move(shape), by_m);
}

ShapePtr half_space(const glm::vec3& point_m, const glm::vec3& normal) {
    return std::make_shared<HalfSpace>(point_m, normal);
}

Curve make_curve(const std::vector<Knot>& knots, int steps, const glm::vec3& normal_hint) {
    Curve curve;
    const auto count = static_cast<int>(knots.size());
    const auto knot = [&](int i) {
        return knots[static_cast<std::size_t>(std::clamp(i, 0, count - 1))];
    };
    const auto height = [&](int i) {
        return knot(i).height_m > 0.0F ? knot(i).height_m : knot(i).width_m;
    };
    const auto packed = [&](int i) { return glm::vec4(knot(i).position_m, knot(i).width_m); };
    for (int span = 0; span + 1 < count; ++span) {
        const int last = span + 2 == count ? steps : steps - 1;
        for (int step = 0; step <= last; ++step) {
            const float t = static_cast<float>(step) / static_cast<float>(steps);
            const glm::vec4 at =
                catmull_rom(packed(span - 1), packed(span), packed(span + 1), packed(span + 2), t);
            const glm::vec4 high =
                catmull_rom(glm::vec4(height(span - 1)), glm::vec4(height(span)),
                            glm::vec4(height(span + 1)), glm::vec4(height(span + 2)), t);
            // Width and height are equal to the last bit where the knots are round.
            curve.push_back(
                {glm::vec3(at), normal_hint, std::max(at.w, 1e-4F), std::max(high.x, 1e-4F), 0.0F});
        }
    }
    rebuild_frames(curve);
    return curve;
}

void rebuild_frames(Curve& curve) {
    glm::vec3 last_normal(0.577F);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const glm::vec3 before = curve[i > 0 ? i - 1 : 0].position_m;
        const glm::vec3 after = curve[std::min(i + 1, curve.size() - 1)].position_m;
        const glm::vec3 tangent = glm::normalize(after - before);
        glm::vec3 normal = curve[i].normal - tangent * glm::dot(curve[i].normal, tangent);
        if (glm::length(normal) < 0.05F) {
            normal = last_normal - tangent * glm::dot(last_normal, tangent);
        }
        curve[i].normal = last_normal = glm::normalize(normal);
        curve[i].length_m =
            i == 0 ? 0.0F : curve[i - 1].length_m + glm::length(curve[i].position_m - before);
    }
}

std::vector<ShapePtr> tube(const Curve& curve, const TubeStyle& style) {
    std::vector<ShapePtr> segments;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        segments.push_back(std::make_shared<TubeSegment>(curve[i], curve[i + 1], style));
    }
    return segments;
}

glm::mat3 axes_from(const glm::vec3& forward, const glm::vec3& up) {
    const glm::vec3 z = glm::normalize(forward);
    const glm::vec3 x = glm::normalize(glm::cross(up, z));
    return {x, glm::cross(z, x), z};
}

}  // namespace obscura::stimuli
