// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace obscura::app::explorer {

/// Ray-traced accessibility that grows: every pixel has the mean of all the rays that reached it so
/// far, in rounds that are independent of each other.
class Truth {
  public:
    static constexpr int kTile = 32;         ///< pixels along a tile's side
    static constexpr int kRaysOfRound = 16;  ///< a pixel
    static constexpr int kMostRounds = 64;   ///< 1024 rays a pixel

    Truth() = default;
    /// Sizes from 1; no ray yet.
    Truth(int width, int height);

    struct Tile {
        int number = 0;
        int left = 0;
        int top = 0;
        int width = 0;
        int height = 0;
        int round = 0;  ///< from 0
    };
    /// The tile to trace next: of those with the fewest rounds the one nearest to the point of the
    /// image (pixels); nothing: all have kMostRounds. It counts as taken.
    [[nodiscard]] std::optional<Tile> take_tile(double x, double y);

    /// One round of a tile: a value and its standard error a pixel, row by row.
    void add(const Tile& tile, const std::vector<float>& accessibility,
             const std::vector<float>& standard_error);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// Rays of every pixel, the fewest and on average.
    [[nodiscard]] int least_rays() const;
    [[nodiscard]] double mean_rays() const;
    [[nodiscard]] bool done() const { return least_rays() >= kMostRounds * kRaysOfRound; }
    /// Rises with every tile.
    [[nodiscard]] std::uint64_t version() const { return version_; }

    /// At a pixel by its place in the upper-row-first list; rays 0: nothing is known.
    [[nodiscard]] int rays(std::size_t pixel) const;
    [[nodiscard]] float accessibility(std::size_t pixel) const;
    [[nodiscard]] float standard_error(std::size_t pixel) const;

  private:
    [[nodiscard]] std::size_t tile_of(std::size_t pixel) const;

    int width_ = 0;
    int height_ = 0;
    int columns_ = 0;
    std::vector<double> sum_;       ///< of the rounds' values
    std::vector<double> variance_;  ///< sum of their squared errors
    std::vector<int> taken_;        ///< rounds that were taken of each tile
    std::vector<int> added_;        ///< and came back
    std::uint64_t version_ = 0;
};

}  // namespace obscura::app::explorer
