// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace obscura::app::explorer {

Truth::Truth(int width, int height)
    : width_(width), height_(height), columns_((width + kTile - 1) / kTile) {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto tiles =
        static_cast<std::size_t>(columns_) * static_cast<std::size_t>((height + kTile - 1) / kTile);
    sum_.resize(pixels);
    variance_.resize(pixels);
    taken_.resize(tiles);
    added_.resize(tiles);
}

std::optional<Truth::Tile> Truth::take_tile(double x, double y) {
    std::size_t best = taken_.size();
    int fewest = kMostRounds;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < taken_.size(); ++i) {
        const auto column = static_cast<int>(i) % columns_;
        const auto row = static_cast<int>(i) / columns_;
        const double away = std::hypot((column + 0.5) * kTile - x, (row + 0.5) * kTile - y);
        if (taken_[i] < fewest || (taken_[i] == fewest && fewest < kMostRounds && away < nearest)) {
            fewest = taken_[i];
            nearest = away;
            best = i;
        }
    }
    if (best == taken_.size()) return std::nullopt;
    Tile tile;
    tile.number = static_cast<int>(best);
    tile.left = tile.number % columns_ * kTile;
    tile.top = tile.number / columns_ * kTile;
    tile.width = std::min(kTile, width_ - tile.left);
    tile.height = std::min(kTile, height_ - tile.top);
    tile.round = taken_[best]++;
    return tile;
}

void Truth::add(const Tile& tile, const std::vector<float>& accessibility,
                const std::vector<float>& standard_error) {
    std::size_t from = 0;
    for (int y = tile.top; y < tile.top + tile.height; ++y) {
        for (int x = tile.left; x < tile.left + tile.width; ++x, ++from) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x);
            const double error = standard_error[from];
            sum_[pixel] += accessibility[from];
            variance_[pixel] += error * error;
        }
    }
    ++added_[static_cast<std::size_t>(tile.number)];
    ++version_;
}

int Truth::least_rays() const {
    if (added_.empty()) return 0;
    return kRaysOfRound * *std::min_element(added_.begin(), added_.end());
}

double Truth::mean_rays() const {
    if (added_.empty()) return 0.0;
    return static_cast<double>(kRaysOfRound) * std::accumulate(added_.begin(), added_.end(), 0) /
           static_cast<double>(added_.size());
}

std::size_t Truth::tile_of(std::size_t pixel) const {
    const std::size_t x = pixel % static_cast<std::size_t>(width_);
    const std::size_t y = pixel / static_cast<std::size_t>(width_);
    return y / kTile * static_cast<std::size_t>(columns_) + x / kTile;
}

int Truth::rays(std::size_t pixel) const { return kRaysOfRound * added_[tile_of(pixel)]; }

float Truth::accessibility(std::size_t pixel) const {
    const int rounds = added_[tile_of(pixel)];
    return rounds > 0 ? static_cast<float>(sum_[pixel] / rounds) : 1.0F;
}

float Truth::standard_error(std::size_t pixel) const {
    const int rounds = added_[tile_of(pixel)];
    return rounds > 0 ? static_cast<float>(std::sqrt(variance_[pixel]) / rounds) : 0.5F;
}

}  // namespace obscura::app::explorer
