// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/light/environment.h"

namespace obscura::renderer {

/// All directions in rows from pole to pole, each row in cells about as wide as it is high. With an
/// even number of rows the horizon is a border between cells.
class DirectionCells {
  public:
    /// `rows` from 2 to 64; about 4 / pi times its square are the cells.
    explicit DirectionCells(int rows);
    [[nodiscard]] int rows() const { return static_cast<int>(first_.size()) - 1; }
    [[nodiscard]] int size() const { return first_.back(); }
    [[nodiscard]] int first_of(int row) const { return first_[static_cast<std::size_t>(row)]; }
    [[nodiscard]] int in_row(int row) const { return first_of(row + 1) - first_of(row); }
    /// A unit vector in each cell, row by row from +Y: one of kStrata places that share the cell
    /// evenly.
    [[nodiscard]] const std::vector<glm::vec3>& ways(int stratum) const {
        return ways_[static_cast<std::size_t>(stratum)];
    }
    static constexpr int kStrata = 8;

  private:
    std::vector<int> first_;  ///< of each row, and one more: how many there are
    std::array<std::vector<glm::vec3>, kStrata> ways_;
};

/// What arrives through each cell adds to irradiance / pi, so that an environment whose cells are
/// all open has the irradiance of project_irradiance but for rounding.
struct IrradiancePart {
    std::array<float, 9> of_one{};  ///< of a radiance of 1 from all of the cell
    IrradianceSh of_environment{};
};

/// By cell. An environment of few texels is looked at between them.
[[nodiscard]] std::vector<IrradiancePart> irradiance_parts(const Environment& environment,
                                                           const DirectionCells& cells);

}  // namespace obscura::renderer
