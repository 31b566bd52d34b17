// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/base/random.h"

namespace obscura::renderer {
namespace {

constexpr int kNoiseSide = 64;
constexpr int kNoiseCells = kNoiseSide * kNoiseSide;

/// Points on a torus and how crowded every cell is with them.
class Crowd {
  public:
    Crowd() : taken_(kNoiseCells, false), energy_(kNoiseCells, 0.0) {
        constexpr double kSigma = 1.9;
        for (int y = 0; y < kNoiseSide; ++y) {
            for (int x = 0; x < kNoiseSide; ++x) {
                const int dx = std::min(x, kNoiseSide - x);
                const int dy = std::min(y, kNoiseSide - y);
                around_.push_back(std::exp(-(dx * dx + dy * dy) / (2.0 * kSigma * kSigma)));
            }
        }
    }

    [[nodiscard]] bool has(int cell) const { return taken_[static_cast<std::size_t>(cell)]; }
    void put(int cell) { change(cell, true); }
    void take(int cell) { change(cell, false); }
    [[nodiscard]] int tightest() const { return best(true); }
    [[nodiscard]] int emptiest() const { return best(false); }

  private:
    void change(int cell, bool to) {
        taken_[static_cast<std::size_t>(cell)] = to;
        const int at_x = cell % kNoiseSide;
        const int at_y = cell / kNoiseSide;
        for (int y = 0; y < kNoiseSide; ++y) {
            const double* row =
                &around_[static_cast<std::size_t>((y - at_y) & (kNoiseSide - 1)) * kNoiseSide];
            double* energy = &energy_[static_cast<std::size_t>(y) * kNoiseSide];
            for (int x = 0; x < kNoiseSide; ++x) {
                energy[x] += (to ? 1.0 : -1.0) * row[(x - at_x) & (kNoiseSide - 1)];
            }
        }
    }

    /// The taken cell with the most around it, or the free one with the least.
    [[nodiscard]] int best(bool taken) const {
        int found = -1;
        for (int i = 0; i < kNoiseCells; ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (taken_[at] != taken) continue;
            const auto held = static_cast<std::size_t>(found);
            if (found < 0 || (taken ? energy_[at] > energy_[held] : energy_[at] < energy_[held])) {
                found = i;
            }
        }
        return found;
    }

    std::vector<bool> taken_;
    std::vector<double> energy_;
    std::vector<double> around_;
};

/// Each cell's rank, 0 to kNoiseCells - 1: however many are kept, from the lowest, they are evenly
/// apart.
std::vector<int> blue_ranks() {
    constexpr int kFirst = kNoiseCells / 10;
    base::Random random(19930201);
    Crowd crowd;
    for (int placed = 0; placed < kFirst;) {
        const int cell =
            std::min(static_cast<int>(random.uniform(0.0, kNoiseCells)), kNoiseCells - 1);
        if (crowd.has(cell)) continue;
        crowd.put(cell);
        ++placed;
    }
    for (int i = 0; i < kNoiseCells; ++i) {
        const int tightest = crowd.tightest();
        crowd.take(tightest);
        const int emptiest = crowd.emptiest();
        crowd.put(emptiest);
        if (emptiest == tightest) break;
    }
    std::vector<int> ranks(kNoiseCells);
    Crowd fewer = crowd;
    for (int rank = kFirst - 1; rank >= 0; --rank) {
        const int cell = fewer.tightest();
        fewer.take(cell);
        ranks[static_cast<std::size_t>(cell)] = rank;
    }
    // Ulichney's third phase turns points and gaps round; the same order without it, as the
    // energies of all cells add up to the same.
    for (int rank = kFirst; rank < kNoiseCells; ++rank) {
        const int cell = crowd.emptiest();
        crowd.put(cell);
        ranks[static_cast<std::size_t>(cell)] = rank;
    }
    return ranks;
}

Tile<glm::dvec2> blue_tile() {
    const std::vector<int> ranks = blue_ranks();
    const auto value = [&ranks](int x, int y) {
        const int cell = (y % kNoiseSide) * kNoiseSide + x % kNoiseSide;
        return (ranks[static_cast<std::size_t>(cell)] + 0.5) / kNoiseCells;
    };
    Tile<glm::dvec2> tile{kNoiseSide, {}};
    for (int y = 0; y < kNoiseSide; ++y) {
        for (int x = 0; x < kNoiseSide; ++x) {
            tile.values.emplace_back(value(x, y), value(x + kNoiseSide / 2, y + kNoiseSide / 2));
        }
    }
    return tile;
}

/// How far along the Hilbert curve through the tile a pixel lies.
int hilbert_index(int x, int y) {
    int index = 0;
    for (int side = kNoiseSide / 2; side > 0; side /= 2) {
        const int right = (x & side) != 0 ? 1 : 0;
        const int up = (y & side) != 0 ? 1 : 0;
        index += side * side * ((3 * right) ^ up);
        if (up == 0) {
            if (right == 1) {
                x = kNoiseSide - 1 - x;
                y = kNoiseSide - 1 - y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

Tile<glm::dvec2> hilbert_tile() {
    constexpr double kPlastic = 1.32471795724474602596;
    const auto part = [](double value) { return value - std::floor(value); };
    Tile<glm::dvec2> tile{kNoiseSide, {}};
    for (int y = 0; y < kNoiseSide; ++y) {
        for (int x = 0; x < kNoiseSide; ++x) {
            const double i = hilbert_index(x, y);
            tile.values.emplace_back(part(0.5 + i / kPlastic),
                                     part(0.5 + i / (kPlastic * kPlastic)));
        }
    }
    return tile;
}

}  // namespace

const Tile<glm::dvec2>& noise_tile(std::string_view kind) {
    static const Tile<glm::dvec2> hilbert = hilbert_tile();
    if (kind == "hilbert64") return hilbert;
    static const Tile<glm::dvec2> blue = blue_tile();
    return blue;
}

}  // namespace obscura::renderer
