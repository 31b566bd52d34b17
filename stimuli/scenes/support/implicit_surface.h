// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/scene/scene.h"
#include "stimuli/scenes/support/implicit_shapes.h"

namespace obscura::stimuli {

/// What a stroke does to the solid made so far.
enum class Blend {
    kAdd,    ///< union
    kCarve,  ///< what the stroke covers is taken away
    kKeep,   ///< only what the stroke covers remains
};

/// How a stroke is applied.
struct StrokeStyle {
    float blend_m = 0.0F;  ///< width of the rounded transition; 0 is a sharp edge
    glm::vec3 tint{1.0F};  ///< linear colour of the surface that the stroke makes
    bool tints = true;     ///< false: the surface keeps the colour it had
};

/// A relief over the whole solid: height in metres by which the surface is raised at a point.
struct Displacement {
    std::function<float(const glm::vec3&)> height_m;
    float high_m = 0.0F;  ///< largest absolute value that height_m returns
};

/// A solid modelled stroke by stroke, in order, as a signed distance field.
class Sculpture {
  public:
    void add(ShapePtr shape, const StrokeStyle& style = {});
    /// The shapes are joined sharply with each other first, then blended as one stroke.
    void add(const std::vector<ShapePtr>& shapes, const StrokeStyle& style = {});
    void carve(ShapePtr shape, const StrokeStyle& style = {});
    void carve(const std::vector<ShapePtr>& shapes, const StrokeStyle& style = {});
    void keep(ShapePtr shape, const StrokeStyle& style = {});
    void displace(Displacement displacement);

    [[nodiscard]] float distance(const glm::vec3& point_m) const;
    [[nodiscard]] ShapeBounds bounds() const;

    /// One shape of a stroke, as the evaluation walks over them.
    struct Part {
        const Shape* shape = nullptr;
        std::uint32_t stroke = 0;
        glm::vec3 centre_m{0.0F};  ///< of a sphere around the shape
        float radius_m = 0.0F;
        float relief_high_m = 0.0F;
    };
    /// The parts that can matter within `radius_m` of the point, out of `parts`, near the surface.
    [[nodiscard]] std::vector<Part> near(const glm::vec3& point_m, float radius_m,
                                         std::span<const Part> parts) const;
    /// Replaces parts that are sculptures themselves by what of them is near; `owners` keeps the
    /// replacements alive.
    void localise(const glm::vec3& point_m, float radius_m, std::vector<Part>& parts,
                  std::vector<ShapePtr>& owners) const;
    [[nodiscard]] std::span<const Part> parts() const { return parts_; }
    /// By how much the surface of the parts may be raised or lowered at most.
    [[nodiscard]] float relief_high(std::span<const Part> parts) const;
    [[nodiscard]] float distance(const glm::vec3& point_m, std::span<const Part> parts) const;
    /// As distance() where that is below the limit; otherwise anything not below it.
    [[nodiscard]] float distance_below(const glm::vec3& point_m, float limit_m,
                                       std::span<const Part> parts) const;
    [[nodiscard]] glm::vec3 tint(const glm::vec3& point_m, std::span<const Part> parts) const;

  private:
    struct Stroke {
        Blend blend = Blend::kAdd;
        StrokeStyle style;
        float margin_m = 0.0F;  ///< within which the stroke can change the surface
    };
    /// The distance to the stroke that starts at parts[i], or anything not below the limit; moves i
    /// to the next stroke.
    [[nodiscard]] static float stroke_distance(const glm::vec3& point_m,
                                               std::span<const Part> parts, std::size_t& i,
                                               float limit_m);
    [[nodiscard]] float undisplaced(const glm::vec3& point_m, std::span<const Part> parts) const;
    [[nodiscard]] float limit_of(const Stroke& stroke, float so_far) const;
    void stroke(Blend blend, const std::vector<ShapePtr>& shapes, const StrokeStyle& style);

    std::vector<ShapePtr> shapes_;
    std::vector<Part> parts_;
    std::vector<Stroke> strokes_;
    Displacement displacement_;
    float widest_blend_m_ = 0.0F;
};

/// The sculpture as one shape of another.
[[nodiscard]] ShapePtr as_shape(Sculpture sculpture);

/// Colours a vertex from where it is, which way it faces and the tint of the strokes there; gives
/// the linear factor of the albedo in [0, 1].
using Painter = std::function<glm::vec3(const glm::vec3& position_m, const glm::vec3& normal,
                                        const glm::vec3& tint)>;

/// Triangulates the zero surface by surface nets (Gibson 1998) on a grid of cells of `cell_m`, its
/// vertices then moved onto the surface, normals from the field's gradient where
/// the triangles follow it. Blocks of cells that
/// the surface cannot reach are never looked at. The result does not depend on the number of
/// threads. Tangents are set perpendicular to the normals; uv stays 0.
[[nodiscard]] renderer::Mesh polygonise(const Sculpture& sculpture, float cell_m,
                                        const Painter& painter = nullptr);

}  // namespace obscura::stimuli
