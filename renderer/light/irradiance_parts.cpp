// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/light/irradiance_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/check.h"
#include "renderer/base/parallel.h"

namespace obscura::renderer {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// As direction_of_texel has it.
glm::dvec3 direction_of(double phi, double theta) {
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

/// The sums of one cell.
struct Sums {
    std::array<double, 9> of_one{};
    std::array<glm::dvec3, 9> of_environment{};
};

/// The middles of an environment's texels, or of equal parts of them, from column to column.
struct Columns {
    int parts;
    std::vector<double> sine;
    std::vector<double> cosine;

    explicit Columns(int count, int of_texel) : parts(of_texel) {
        for (int i = 0; i < count * parts; ++i) {
            const double phi = kTurn * (i + 0.5) / (count * parts);
            sine.push_back(std::sin(phi));
            cosine.push_back(std::cos(phi));
        }
    }
};

void add_row(const Environment& environment, const Columns& columns, int fine_row, int fine_rows,
             std::vector<Sums>& cells) {
    const double theta = std::numbers::pi * (fine_row + 0.5) / fine_rows;
    const std::size_t across = columns.sine.size();
    const double solid_angle = kTurn / static_cast<double>(across) *
                               (std::cos(std::numbers::pi * fine_row / fine_rows) -
                                std::cos(std::numbers::pi * (fine_row + 1) / fine_rows));
    const auto first_texel = static_cast<std::size_t>(fine_row / columns.parts) *
                             static_cast<std::size_t>(environment.width);
    const double height = std::cos(theta);
    const double out = std::sin(theta);
    for (std::size_t i = 0; i < across; ++i) {
        const std::array<double, 9> y =
            harmonics({out * columns.sine[i], height, -out * columns.cosine[i]});
        const glm::dvec3 radiance =
            environment.radiance[first_texel + i / static_cast<std::size_t>(columns.parts)];
        Sums& cell = cells[i * cells.size() / across];
        for (std::size_t k = 0; k < 9; ++k) {
            const double share = y[k] * solid_angle;
            cell.of_one[k] += share;
            cell.of_environment[k] += radiance * share;
        }
    }
}

}  // namespace

DirectionCells::DirectionCells(int rows) {
    base::check_range("DirectionCells", "rows", rows, 2, 64);
    first_.push_back(0);
    for (int row = 0; row < rows; ++row) {
        const double theta = std::numbers::pi * (row + 0.5) / rows;
        const int across = std::max(3, static_cast<int>(std::lround(2.0 * rows * std::sin(theta))));
        for (int stratum = 0; stratum < kStrata; ++stratum) {
            // A lattice of rank one: a place in each eighth of either side.
            const double down = (stratum + 0.5) / kStrata;
            const double along = (3 * stratum % kStrata + 0.5) / kStrata;
            for (int i = 0; i < across; ++i) {
                ways_[static_cast<std::size_t>(stratum)].emplace_back(direction_of(
                    kTurn * (i + along) / across, std::numbers::pi * (row + down) / rows));
            }
        }
        first_.push_back(first_.back() + across);
    }
}

std::vector<IrradiancePart> irradiance_parts(const Environment& environment,
                                             const DirectionCells& cells) {
    // Enough of them that each cell has some.
    constexpr int kLeastRows = 256;
    const int parts = std::max(1, (kLeastRows + environment.height - 1) / environment.height);
    const int fine_rows = environment.height * parts;
    const Columns columns(environment.width, parts);
    std::vector<IrradiancePart> result(static_cast<std::size_t>(cells.size()));
    base::in_parallel(cells.rows(), 0, [&](int row) {
        std::vector<Sums> sums(static_cast<std::size_t>(cells.in_row(row)));
        const auto border = [&](int of) {  // the first row whose middle lies beyond
            return static_cast<int>(
                std::ceil(static_cast<double>(of) * fine_rows / cells.rows() - 0.5));
        };
        for (int fine_row = border(row); fine_row < border(row + 1); ++fine_row) {
            add_row(environment, columns, fine_row, fine_rows, sums);
        }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            IrradiancePart& part = result[static_cast<std::size_t>(cells.first_of(row)) + i];
            for (std::size_t k = 0; k < 9; ++k) {
                part.of_one[k] = static_cast<float>(sums[i].of_one[k] * kCosineLobe[k]);
                part.of_environment[k] = sums[i].of_environment[k] * kCosineLobe[k];
            }
        }
    });
    return result;
}

}  // namespace obscura::renderer
