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
    std::vector<std::string> libraries;  ///< the files of materials that it names
    std::vector<std::string> materials;  ///< what the text calls m0, m1, ...
    bool has_normals = false;            ///< every corner has one
    std::size_t triangles = 0;           ///< that its polygons make
};

/// Checks every line, so that the library that makes meshes of it meets only sound ones. Throws
/// bad input naming file and line: a number that is none or not finite, an index of nothing, a face
/// of fewer than three corners, more triangles than kMostObjTriangles. Statements that are not
/// shown (lines, curves) are noted.
[[nodiscard]] CheckedObj check_obj(std::string_view text, const std::string& name, Notes& notes);

/// Above this an OBJ file would take more than 2 GiB to read; glTF takes a tenth of it.
inline constexpr std::size_t kMostObjTriangles = 3'000'000;

/// The words of a line, without its comment.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);

/// The next line of `rest`, which loses it; a line that ends in a backslash goes on in the next
/// one. `number` counts the lines taken.
[[nodiscard]] std::string next_line(std::string_view& rest, int& number);

/// A finite number that is the whole word.
[[nodiscard]] bool parse_number(std::string_view word, double& value);

}  // namespace obscura::renderer::import_detail
