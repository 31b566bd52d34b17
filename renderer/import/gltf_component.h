// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/import/gltf_check.h"

namespace obscura::renderer::import_detail {

// How the elements of accessors lie in memory (glTF 2.0, 3.6.2.4).

/// Bytes of a component of that type, 5120 to 5126.
[[nodiscard]] std::size_t component_bytes(int type);

/// Where the components of one element lie: columns of a matrix begin at multiples of four bytes.
[[nodiscard]] std::vector<std::size_t> component_offsets(const GltfAccessor& accessor);

/// Bytes from the first to the last component of an element.
[[nodiscard]] std::size_t element_bytes(const GltfAccessor& accessor);

/// The unsigned integer of that type at `at`.
[[nodiscard]] std::uint32_t integer_at(const char* at, int type);

}  // namespace obscura::renderer::import_detail
