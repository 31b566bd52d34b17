// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace obscura::stimuli {

/// An axis-aligned box in metres; empty until something is put in.
struct ShapeBounds {
    glm::vec3 low{1e9F};
    glm::vec3 high{-1e9F};

    void include(const glm::vec3& point_m, float radius_m);
    void include(const ShapeBounds& other);
};

/// A solid given by its signed distance: negative inside. All lengths in metres.
class Shape {
  public:
    virtual ~Shape() = default;
    /// Signed distance, exact or of first order near the surface; its sign is always right.
    [[nodiscard]] virtual float distance(const glm::vec3& point_m) const = 0;
    /// As distance() where that is below `limit_m`; otherwise anything not below the limit.
    [[nodiscard]] virtual float distance_below(const glm::vec3& point_m, float limit_m) const {
        static_cast<void>(limit_m);
        return distance(point_m);
    }
    /// How far the surface is raised there above what distance() says: 0 for most shapes.
    [[nodiscard]] virtual float relief(const glm::vec3& point_m) const {
        static_cast<void>(point_m);
        return 0.0F;
    }
    /// Largest value of relief().
    [[nodiscard]] virtual float relief_high() const { return 0.0F; }
    /// Never more than the true distance to the raised solid; may be coarser than distance().
    [[nodiscard]] virtual float lower_bound(const glm::vec3& point_m) const = 0;
    [[nodiscard]] virtual ShapeBounds bounds() const = 0;
    /// A cheaper shape that is the same within `radius_m` of the point wherever its distance is
    /// below `radius_m`; null where this one is cheap enough. It must not outlive this one.
    [[nodiscard]] virtual std::shared_ptr<const Shape> restricted(const glm::vec3& point_m,
                                                                  float radius_m) const {
        static_cast<void>(point_m);
        static_cast<void>(radius_m);
        return nullptr;
    }
};
using ShapePtr = std::shared_ptr<const Shape>;

/// The convex hull of two spheres.
[[nodiscard]] ShapePtr round_cone(const glm::vec3& a_m, float radius_a_m, const glm::vec3& b_m,
                                  float radius_b_m);
[[nodiscard]] ShapePtr ball(const glm::vec3& centre_m, float radius_m);
/// Half-axes `radii_m` along the columns of `axes` (a rotation).
[[nodiscard]] ShapePtr ellipsoid(const glm::vec3& centre_m, const glm::vec3& radii_m,
                                 const glm::mat3& axes = glm::mat3(1.0F));
/// Half-edges `half_m` along the columns of `axes`, edges rounded by `rounding_m`.
[[nodiscard]] ShapePtr rounded_box(const glm::vec3& centre_m, const glm::vec3& half_m,
                                   float rounding_m, const glm::mat3& axes = glm::mat3(1.0F));
/// Everything on the side of the plane that `normal` (unit length) points away from.
[[nodiscard]] ShapePtr half_space(const glm::vec3& point_m, const glm::vec3& normal);

/// The shape grown by `by_m` on all sides (shrunk where negative).
[[nodiscard]] ShapePtr grown(ShapePtr shape, float by_m);

/// A point of a curve that a section is swept along.
struct CurvePoint {
    glm::vec3 position_m{0.0F};
    glm::vec3 normal{0.0F, 1.0F, 0.0F};  ///< unit length, across the curve; angle 0
    float width_m = 0.01F;               ///< half-axis of the section along the normal
    float height_m = 0.01F;              ///< half-axis across normal and curve
    float length_m = 0.0F;               ///< along the curve from its start
};
using Curve = std::vector<CurvePoint>;

/// A knot of a curve: position and half-axes of the section.
struct Knot {
    glm::vec3 position_m{0.0F};
    float width_m = 0.01F;
    float height_m = 0.0F;  ///< 0: as width_m, a round section
};

/// A place that parts are modelled at: right, up and forward are the columns.
struct Placed {
    glm::vec3 origin_m{0.0F};
    glm::mat3 axes{1.0F};

    [[nodiscard]] glm::vec3 operator()(float right, float up, float forward) const {
        return origin_m + axes * glm::vec3(right, up, forward);
    }
    [[nodiscard]] Knot knot(float right, float up, float forward, float width_m,
                            float height_m = 0.0F) const {
        return {(*this)(right, up, forward), width_m, height_m};
    }
};

/// A Catmull-Rom spline through the knots, `steps` points a span; normals are `normal_hint` made
/// perpendicular to the curve (carried on from the last point where the two are parallel).
[[nodiscard]] Curve make_curve(const std::vector<Knot>& knots, int steps,
                               const glm::vec3& normal_hint);
/// Makes the normals perpendicular again and measures the lengths after positions were changed.
void rebuild_frames(Curve& curve);

/// Where on a tube a point lies.
struct TubePoint {
    float along_m = 0.0F;    ///< length along the curve
    float angle_rad = 0.0F;  ///< (-pi, pi], 0 along the normal
    float radius_m = 0.0F;   ///< of the section there
    glm::vec3 position_m{0.0F};
};
/// Height in metres by which a tube's surface is raised there.
using Relief = std::function<float(const TubePoint&)>;

struct TubeStyle {
    bool squarish = false;    ///< section is a superellipse of power 4, for straps and plates
    Relief relief = nullptr;  ///< optional
    float relief_high_m = 0;  ///< largest height that the relief returns
};

/// One shape per segment, meant to be joined by a plain union.
[[nodiscard]] std::vector<ShapePtr> tube(const Curve& curve, const TubeStyle& style = {});

/// A rotation whose second column is `up` made perpendicular to `forward`, the third column.
[[nodiscard]] glm::mat3 axes_from(const glm::vec3& forward, const glm::vec3& up);

}  // namespace obscura::stimuli
