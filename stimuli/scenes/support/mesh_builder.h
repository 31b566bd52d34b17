// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::stimuli {

// Parts of scenes. Each function returns a finished mesh (unit normals, tangents, triangles
// counter-clockwise from outside) whose uv are in metres; append() scales them to the texture.

/// A mesh over the unit square.
struct PatchOptions {
    int columns = 16;        ///< cells along u, >= 1
    int rows = 16;           ///< cells along v, >= 1
    glm::vec2 size_m{1.0F};  ///< lengths of the two directions: uv = (u, v) * size_m
    bool closed_u = false;   ///< u = 1 is the same place as u = 0 (smooth across the seam)
    bool closed_v = false;
};
/// `position(u, v)` in metres; the outside is cross(d/du, d/dv). Normals come from differences.
[[nodiscard]] renderer::Mesh patch(const PatchOptions& options,
                                   const std::function<glm::vec3(float u, float v)>& position);

/// A box around the origin whose edges and corners are cut by `bevel_m` and shaded round.
[[nodiscard]] renderer::Mesh bevelled_box(glm::vec3 size_m, float bevel_m);

/// A surface of revolution about +Y. `profile` holds (radius, height) in metres from bottom to top
/// on the outside; radius 0 closes an end. Edges sharper than the crease angle stay sharp.
[[nodiscard]] renderer::Mesh revolve(std::span<const glm::vec2> profile, int segments,
                                     float crease_rad = 0.7F);

/// Where a profile is put: its x axis, its y axis and its place. The path runs along
/// cross(x_axis, y_axis).
struct ProfileFrame {
    glm::vec3 origin_m{0.0F};
    glm::vec3 x_axis{1.0F, 0.0F, 0.0F};
    glm::vec3 y_axis{0.0F, 1.0F, 0.0F};
};
struct SweepOptions {
    bool closed_profile = true;  ///< the last point joins the first
    bool closed_path = false;    ///< the last frame joins the first
    bool caps = true;            ///< close the ends; the profile must be star-shaped about its mean
    float crease_rad = 0.6F;
};
/// Carries a profile (counter-clockwise in its x and y axes, metres) through the frames.
[[nodiscard]] renderer::Mesh sweep(std::span<const glm::vec2> profile,
                                   std::span<const ProfileFrame> frames,
                                   const SweepOptions& options = {});

/// Frames along a polyline, without twist; `up` is the y axis where the path is level.
[[nodiscard]] std::vector<ProfileFrame> frames_along(std::span<const glm::vec3> path_m,
                                                     glm::vec3 up, bool closed = false);

/// Points of a circle of that radius, counter-clockwise.
[[nodiscard]] std::vector<glm::vec2> circle(float radius_m, int segments);

/// How a part is put into a whole.
struct Placement {
    glm::mat4 transform{1.0F};  ///< no shear; a mirror turns the triangles round
    glm::vec2 uv_scale{1.0F};   ///< repeats per metre
    glm::vec2 uv_offset{0.0F};  ///< repeats, added after the scale
    glm::vec3 tint{1.0F};       ///< factor of the vertex colour, [0, 1]
};
/// Adds a copy of `part` to `whole`; the material of `whole` stays.
void append(renderer::Mesh& whole, const renderer::Mesh& part, const Placement& placement = {});

/// Multiplies the colour of each vertex by `colour(position_m, normal)`, linear in [0, 1].
void paint(renderer::Mesh& mesh,
           const std::function<glm::vec3(const glm::vec3&, const glm::vec3&)>& colour);

/// Gives every vertex the uv of its position seen along the main axis of its triangle's normal,
/// in metres, and splits vertices where the axis changes. v runs down, u to the right as seen from
/// outside. Tangents are made anew.
void project_box_uv(renderer::Mesh& mesh);

/// Normals by area-weighted means over the triangles that meet at a place with angles below
/// `crease_rad`; vertices are split at creases, places are welded within 10 micrometres.
/// Triangles without area are removed. Tangents are made anew.
void smooth_normals(renderer::Mesh& mesh, float crease_rad);

/// Puts every vertex normal on the outer side of each face that it is used by, at most 90 degrees
/// off: a vertex whose normal is not takes the area-weighted mean of its faces, and where that does
/// not hold for all of them, those that it is turned for get vertices of their own. For meshes
/// whose normals come from a formula, which knows nothing of how coarsely the surface was cut.
void turn_normals_outwards(renderer::Mesh& mesh);

/// Unit tangents along +u with handedness, from uv; perpendicular to the normals.
void make_tangents(renderer::Mesh& mesh);

/// A unit vector perpendicular to a unit vector.
[[nodiscard]] glm::vec3 any_perpendicular(const glm::vec3& direction);

}  // namespace obscura::stimuli
