// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

namespace obscura::renderer::import_detail {

/// Gives every triangle corners of its own with the triangle's normal (glTF 2.0, 3.7.2.1: flat
/// normals where none are given).
void make_flat_normals(Mesh& mesh);

/// Replaces normals that are no direction by the mean of the triangles around, weighted by area;
/// others become unit length where they are not within 0.001. Returns how many were replaced.
std::size_t mend_normals(Mesh& mesh);

/// How many triangles have an area, and of these how many have a corner whose normal points to the
/// other side than their order of corners says.
struct Sides {
    std::size_t with_area = 0;
    std::size_t with_turned_normal = 0;
};
[[nodiscard]] Sides sides_of(const Mesh& mesh);

/// For formats whose order of corners says nothing: turns over the triangles that lie on the other
/// side of the mean of their corners' normals. Returns how many.
std::size_t turn_to_normals(Mesh& mesh);

/// Tangents from uv, averaged over the triangles at a vertex, perpendicular to its normal. The
/// handedness points the bitangent to -v, up in the image, as the normal maps of glTF 2.0 (3.9.3)
/// are made. Vertices of triangles that are mapped both ways round are split.
void make_tangents(Mesh& mesh);

}  // namespace obscura::renderer::import_detail
