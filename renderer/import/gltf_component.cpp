// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/gltf_component.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "renderer/base/error.h"

namespace obscura::renderer::import_detail {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's binary parts are little-endian");

/// A component as it is stored, normalised where asked (glTF 2.0, 3.11).
float component_at(const char* at, int type, bool normalized) {
    const auto load = [at](auto value) {
        std::memcpy(&value, at, sizeof value);
        return value;
    };
    switch (type) {
        case 5120: {
            const auto value = static_cast<float>(load(std::int8_t{}));
            return normalized ? std::max(value / 127.0F, -1.0F) : value;
        }
        case 5121: {
            const auto value = static_cast<float>(load(std::uint8_t{}));
            return normalized ? value / 255.0F : value;
        }
        case 5122: {
            const auto value = static_cast<float>(load(std::int16_t{}));
            return normalized ? std::max(value / 32767.0F, -1.0F) : value;
        }
        case 5123: {
            const auto value = static_cast<float>(load(std::uint16_t{}));
            return normalized ? value / 65535.0F : value;
        }
        case 5125:
            return static_cast<float>(load(std::uint32_t{}));
        default:
            return load(0.0F);
    }
}

/// Calls `read(element, bytes)` for each stored element, and then for each that a sparse accessor
/// replaces, whose values lie `element_bytes` apart.
template <typename Read>
void each_element(const GltfAccessor& accessor, std::size_t element_bytes, const Read& read) {
    if (accessor.view) {
        const char* from = accessor.view->bytes.data() + accessor.offset;
        for (std::size_t i = 0; i < accessor.count; ++i) read(i, from + i * accessor.stride);
    }
    if (!accessor.sparse) return;
    const GltfSparse& sparse = *accessor.sparse;
    const char* indices = sparse.indices.bytes.data() + sparse.indices_offset;
    const char* values = sparse.values.bytes.data() + sparse.values_offset;
    for (std::size_t k = 0; k < sparse.count; ++k) {
        read(integer_at(indices + k * component_bytes(sparse.indices_type), sparse.indices_type),
             values + k * element_bytes);
    }
}

}  // namespace

std::size_t component_bytes(int type) {
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        default:
            return 4;
    }
}

std::uint32_t integer_at(const char* at, int type) {
    std::uint32_t value = 0;  // little-endian: the lower bytes come first
    std::memcpy(&value, at, component_bytes(type));
    return value;
}

std::vector<std::size_t> component_offsets(const GltfAccessor& accessor) {
    const std::size_t bytes = component_bytes(accessor.component_type);
    const std::size_t rows = !accessor.is_matrix ? 1
                                                 : (accessor.components == 4   ? 2
                                                    : accessor.components == 9 ? 3
                                                                               : 4);
    const std::size_t column = accessor.is_matrix ? (rows * bytes + 3) / 4 * 4 : bytes;
    std::vector<std::size_t> offsets;
    for (std::size_t i = 0; i < static_cast<std::size_t>(accessor.components); ++i) {
        offsets.push_back(accessor.is_matrix ? i / rows * column + i % rows * bytes : i * bytes);
    }
    return offsets;
}

std::size_t element_bytes(const GltfAccessor& accessor) {
    return component_offsets(accessor).back() + component_bytes(accessor.component_type);
}

std::vector<float> GltfFile::floats(const GltfAccessor& accessor) const {
    const auto components = static_cast<std::size_t>(accessor.components);
    std::vector<float> values(accessor.count * components, 0.0F);
    const std::vector<std::size_t> offsets = component_offsets(accessor);
    const auto read = [&](std::size_t element, const char* from) {
        for (std::size_t c = 0; c < components; ++c) {
            values[element * components + c] =
                component_at(from + offsets[c], accessor.component_type, accessor.normalized);
        }
    };
    each_element(accessor, element_bytes(accessor), read);
    return values;
}

std::vector<std::uint32_t> GltfFile::integers(const GltfAccessor& accessor,
                                              const std::string& place) const {
    const int type = accessor.component_type;
    if (type != 5121 && type != 5123 && type != 5125) {
        throw base::bad_input("{}: {}: its componentType is {}, allowed are 5121, 5123 and 5125",
                              name_, place, type);
    }
    const auto components = static_cast<std::size_t>(accessor.components);
    std::vector<std::uint32_t> values(accessor.count * components, 0);
    const std::size_t bytes = component_bytes(type);
    const auto read = [&](std::size_t element, const char* from) {
        for (std::size_t c = 0; c < components; ++c) {
            values[element * components + c] = integer_at(from + c * bytes, type);
        }
    };
    each_element(accessor, components * bytes, read);
    return values;
}

}  // namespace obscura::renderer::import_detail
