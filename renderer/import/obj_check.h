// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/import/notes.h"

namespace obscura::renderer::import_detail {

/// A Wavefront OBJ text of which only what is sound and shown is left.
struct CheckedObj {
    std::string text;  ///< lines v, vt, vn, f and usemtl; indices positive and in range
    std::vector<std::string> libraries;  ///< what follows each mtllib
    std::vector<std::string> materials;  ///< what the text calls m0, m1, ...; "" is none
    std::size_t faces = 0;
    std::size_t faces_without_normals = 0;  ///< at one corner or more
    std::size_t triangles = 0;              ///< that its polygons make
};

/// Checks every line, so that the library that makes meshes of it meets only sound ones. Faces
/// stand behind all vertices, as they may in the file; faces with and without normals have
/// materials of their own, so that the former keep theirs.
///
/// Positions and faces must be sound: throws bad input naming file, line, what was met and what is
/// wanted for a position that is none, a corner without one, a face of fewer than three corners,
/// more vertices than ImportLimits::kVertices or triangles than kMostObjTriangles. Everything else
/// that cannot be used is replaced or passed over, with a note that names the first places.
[[nodiscard]] CheckedObj check_obj(std::string_view text, const std::string& name, Notes& notes);

/// Above this an OBJ file would take more than 2 GiB to read; glTF takes a tenth of it.
inline constexpr std::size_t kMostObjTriangles = 3'000'000;

}  // namespace obscura::renderer::import_detail
