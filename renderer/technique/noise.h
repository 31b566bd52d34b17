// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace obscura::renderer {

/// Values that repeat over a square of `size` pixels, row by row.
template <typename Value>
struct Tile {
    int size = 1;
    std::vector<Value> values;

    [[nodiscard]] const Value& at(int x, int y) const {
        return values[static_cast<std::size_t>(size * (y % size) + x % size)];
    }
    [[nodiscard]] auto begin() const { return values.begin(); }
    [[nodiscard]] auto end() const { return values.end(); }
};

/// Two numbers in (0, 1) for each pixel, of a kind that Variant::noise names but for `tile4x4`, of
/// which each family of techniques has its own. `blue64`: each over 64x64 pixels every number once,
/// neighbours far apart (void and cluster, Ulichney 1993), the second from half a tile away.
/// `hilbert64`: the R2 sequence (Roberts 2018) along a Hilbert curve, as in Intel's XeGTAO. Made
/// when it is first asked for.
[[nodiscard]] const Tile<glm::dvec2>& noise_tile(std::string_view kind);

}  // namespace obscura::renderer
