// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "renderer/import/gltf_check.h"
#include "renderer/import/gltf_material.h"
#include "renderer/import/import.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer::import_detail {

/// Vertices and triangles that an import may still make.
struct MeshBudget {
    std::size_t vertices = ImportLimits::kVertices;
    std::size_t triangles = ImportLimits::kTriangles;
    std::size_t morph_work = 8 * ImportLimits::kVertices;  ///< vertices moved by morph targets
};

/// Four joints and their weights, for each vertex.
struct SkinWeights {
    std::vector<std::array<std::uint32_t, 4>> joints;
    std::vector<glm::vec4> weights;  ///< sum 1, or all 0 where the file gives none
};

/// A primitive in the space of its mesh.
struct GltfPrimitive {
    Mesh mesh;  ///< uv as the material's textures lie
    bool has_normals = false;
    bool has_tangents = false;
    std::optional<SkinWeights> skin;
};

/// Reads one primitive (glTF 2.0, 3.7.2) with the weights of its morph targets; nothing where it
/// has no triangles. Throws bad input for a coordinate that is not finite, an index beyond the
/// vertices, attributes that do not belong together, more than the budget.
[[nodiscard]] std::optional<GltfPrimitive> read_primitive(const GltfFile& file,
                                                          const JsonCursor& primitive,
                                                          const std::vector<double>& morph_weights,
                                                          GltfMaterials& materials,
                                                          MeshBudget& budget, Notes& notes);

}  // namespace obscura::renderer::import_detail
