// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/plot/labels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace obscura::analysis {

bool Box::overlaps(const Box& other) const {
    return left < other.left + other.width && other.left < left + width &&
           bottom < other.bottom + other.height && other.bottom < bottom + height;
}

bool Box::holds(const Box& other) const {
    return other.left >= left && other.left + other.width <= left + width &&
           other.bottom >= bottom && other.bottom + other.height <= bottom + height;
}

Box room_of(const PointName& name) {
    // Sans-serif letters are half as wide as high on the mean; the widest fonts take this much.
    constexpr double kWidth = 0.62;
    constexpr double kHeight = 1.2;
    return {0.0, 0.0, kWidth * name.font_px * static_cast<double>(name.text.size()),
            kHeight * name.font_px};
}

namespace {

/// The name's room so far from its point, in that direction: its nearest side or corner is there.
Box beside(const PointName& name, double distance_px, double angle_rad) {
    Box box = room_of(name);
    const double x = std::cos(angle_rad);
    const double y = std::sin(angle_rad);
    box.left = name.x + distance_px * x + 0.5 * box.width * (x - 1.0);
    box.bottom = name.y + distance_px * y + 0.5 * box.height * (y - 1.0);
    return box;
}

std::optional<Box> place_of(const PointName& name, const Box& area, const std::vector<Box>& taken) {
    constexpr int kDirections = 24;
    constexpr double kNear_px = 9.0;  // of a point's mark
    constexpr double kLines = 12.0;
    for (double distance = kNear_px; distance < kLines * name.font_px; distance += 4.0) {
        for (int i = 0; i < kDirections; ++i) {
            // To the right first, then by turns above and below.
            const int turn = (i + 1) / 2 * (i % 2 == 1 ? 1 : -1);
            const Box box = beside(name, distance, 2.0 * std::numbers::pi * turn / kDirections);
            const bool free = std::none_of(taken.begin(), taken.end(), [&box](const Box& other) {
                return box.overlaps(other);
            });
            if (free && area.holds(box)) return box;
        }
    }
    return {};
}

}  // namespace

std::vector<std::optional<Box>> places_of(const std::vector<PointName>& names, const Box& area,
                                          const std::vector<Box>& kept_free) {
    std::vector<Box> taken = kept_free;
    std::vector<std::optional<Box>> places;
    for (const PointName& name : names) {
        places.push_back(place_of(name, area, taken));
        if (places.back()) taken.push_back(*places.back());
    }
    return places;
}

}  // namespace obscura::analysis
