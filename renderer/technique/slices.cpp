// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/slices.h"

#include <fmt/format.h>

#include <cmath>

#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {
namespace {

constexpr int kTurns = kTileSize * kTileSize;

Turn turn_by(double angle_rad, double jitter) {
    return {static_cast<float>(std::cos(angle_rad)), static_cast<float>(std::sin(angle_rad)),
            static_cast<float>(jitter)};
}

/// The four bits of `i` the other way round.
int reversed(int i) { return ((i & 1) << 3) | ((i & 2) << 1) | ((i & 4) >> 1) | ((i & 8) >> 3); }

}  // namespace

std::vector<Turn> turn_tile(double sector_rad) {
    std::vector<Turn> tile;
    for (int y = 0; y < kTileSize; ++y) {
        for (int x = 0; x < kTileSize; ++x) {
            // Neighbours in a row or column are far apart in angle.
            const int i = kTileSize * ((x + y) % kTileSize) + x;
            tile.push_back(turn_by(sector_rad * (i + 0.5) / kTurns, (reversed(i) + 0.5) / kTurns));
        }
    }
    return tile;
}

NumberTable turn_table(double sector_rad) {
    NumberTable table{"turns", kTileSize, kTileSize, {}};
    for (const Turn& turn : turn_tile(sector_rad)) {
        table.texels.emplace_back(turn.cosine, turn.sine, turn.jitter);
    }
    return table;
}

std::vector<Turn> direction_turns(int count, double sector_rad) {
    std::vector<Turn> turns;
    for (int i = 0; i < count; ++i) turns.push_back(turn_by(sector_rad * i, 0.0));
    return turns;
}

std::string direction_define(const std::string& name, int count, double sector_rad) {
    std::string list;
    for (const Turn& turn : direction_turns(count, sector_rad)) {
        list +=
            fmt::format("{}vec2({:.9e}, {:.9e})", list.empty() ? "" : ", ", turn.cosine, turn.sine);
    }
    return fmt::format("{} vec2[]({})", name, list);
}

Parameter slice_radius() {
    return {"radius_m", "Distance to which surfaces occlude", "m", 0.0, 1000.0, 0.5, false, false};
}

Parameter slice_reach(double standard) {
    return {"reach", "How far samples look for occluders", "of radius_m", 0.0, 20.0, standard};
}

std::map<Ideal, std::string> slice_nature() {
    return {{Ideal::kWholeScene,
             "what lies outside the image is not in the buffer and reads as very far"}};
}

}  // namespace obscura::renderer
