// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/import/gltf_check.h"

namespace obscura::renderer::import_detail {

/// The nodes of a document, placed.
struct GltfNodes {
    std::vector<glm::dmat4> world_from_node;
    std::vector<std::size_t> shown;  ///< nodes of the scene, parents before children
};

/// Reads the node hierarchy (glTF 2.0, 3.5) and which of it the document's scene shows. `scale` is
/// metres of a unit. Throws bad input for a node that has two parents or is its own ancestor.
[[nodiscard]] GltfNodes read_nodes(const GltfFile& file, double scale, Notes& notes);

}  // namespace obscura::renderer::import_detail
