// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/order/latin_square.h"

#include <array>
#include <numeric>
#include <set>

#include "renderer/base/check.h"

namespace obscura::stimuli {
namespace {

/// A Latin square as a cube of zeros and ones, 1 where (row, column) holds the symbol: every line
/// along every axis sums to 1. An improper cube has one cell of -1.
class IncidenceCube {
  public:
    explicit IncidenceCube(int n) : n_(n), cells_(static_cast<std::size_t>(n) * n * n, 0) {
        for (int row = 0; row < n; ++row) {
            for (int column = 0; column < n; ++column) at({row, column, (row + column) % n}) = 1;
        }
    }

    [[nodiscard]] bool is_proper() const { return !improper_; }

    /// One move of the chain: a random neighbour among the cubes.
    void move(base::Random& random) {
        const Cell cell = improper_ ? negative_ : random_zero(random);
        Cell other{};
        for (int axis = 0; axis < 3; ++axis) other[axis] = random_one(cell, axis, random);
        // Add 1 at `cell` and take it off again along each axis: the corners of a box whose
        // opposite corner is `other`, with signs alternating, keep the sum of every line.
        for (int corner = 0; corner < 8; ++corner) {
            Cell at_corner = cell;
            int sign = 1;
            for (int axis = 0; axis < 3; ++axis) {
                if ((corner >> axis & 1) == 0) continue;
                at_corner[axis] = other[axis];
                sign = -sign;
            }
            at(at_corner) = static_cast<signed char>(at(at_corner) + sign);
        }
        improper_ = at(other) < 0;
        negative_ = other;
    }

    /// Only for a proper cube.
    [[nodiscard]] Square square() const {
        Square rows(n_, std::vector<int>(n_));
        for (int row = 0; row < n_; ++row) {
            for (int column = 0; column < n_; ++column) {
                for (int symbol = 0; symbol < n_; ++symbol) {
                    if (value({row, column, symbol}) == 1) rows[row][column] = symbol;
                }
            }
        }
        return rows;
    }

  private:
    using Cell = std::array<int, 3>;

    [[nodiscard]] std::size_t index(const Cell& cell) const {
        return (static_cast<std::size_t>(cell[0]) * n_ + cell[1]) * n_ + cell[2];
    }
    [[nodiscard]] signed char& at(const Cell& cell) { return cells_[index(cell)]; }
    [[nodiscard]] signed char value(const Cell& cell) const { return cells_[index(cell)]; }

    [[nodiscard]] Cell random_zero(base::Random& random) const {
        const auto coordinate = [&] { return static_cast<int>(random.below(n_)); };
        for (;;) {
            const Cell cell{coordinate(), coordinate(), coordinate()};
            if (value(cell) == 0) return cell;
        }
    }

    /// Where along that axis, from `cell`, a 1 stands; a line through -1 has two, drawn evenly.
    [[nodiscard]] int random_one(Cell cell, int axis, base::Random& random) const {
        std::array<int, 2> places{};
        std::size_t count = 0;
        for (int place = 0; place < n_ && count < places.size(); ++place) {
            cell[axis] = place;
            if (value(cell) == 1) places[count++] = place;
        }
        return places[random.below(count)];
    }

    int n_;
    std::vector<signed char> cells_;
    bool improper_ = false;
    Cell negative_{};  ///< the cell of -1 where improper
};

std::vector<int> random_permutation(int n, base::Random& random) {
    std::vector<int> values(n);
    std::iota(values.begin(), values.end(), 0);
    random.shuffle(values);
    return values;
}

}  // namespace

Square random_latin_square(int n, base::Random& random) {
    base::check_range("latin square", "order", n, 1, kMostConditions);
    if (n == 1) return {{0}};
    IncidenceCube cube(n);
    for (int proper = 0; proper < n * n + 16;) {
        cube.move(random);
        if (cube.is_proper()) ++proper;
    }
    const Square square = cube.square();
    const std::vector<int> rows = random_permutation(n, random);
    const std::vector<int> columns = random_permutation(n, random);
    const std::vector<int> symbols = random_permutation(n, random);
    Square permuted = square;
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            permuted[rows[row]][columns[column]] = symbols[square[row][column]];
        }
    }
    return permuted;
}

bool is_latin(const Square& square) {
    const std::size_t n = square.size();
    const auto complete = [n](const std::set<int>& symbols) {
        return symbols.size() == n &&
               (n == 0 || (*symbols.begin() == 0 && *symbols.rbegin() == static_cast<int>(n) - 1));
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (square[i].size() != n || !complete({square[i].begin(), square[i].end()})) return false;
    }
    for (std::size_t column = 0; column < n; ++column) {
        std::set<int> symbols;
        for (const std::vector<int>& row : square) symbols.insert(row[column]);
        if (!complete(symbols)) return false;
    }
    return true;
}

}  // namespace obscura::stimuli
