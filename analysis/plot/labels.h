// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace obscura::analysis {

/// A rectangle of a picture, in pixels from its lower left corner.
struct Box {
    double left = 0.0;
    double bottom = 0.0;
    double width = 0.0;
    double height = 0.0;

    [[nodiscard]] bool overlaps(const Box& other) const;
    [[nodiscard]] bool holds(const Box& other) const;
};

/// A name that a point of a picture is to have.
struct PointName {
    double x = 0.0;  ///< of the point, pixels
    double y = 0.0;
    std::string text;
    double font_px = 14.0;
};

/// The room that a name in a sans-serif font takes, its lower left corner at 0.
[[nodiscard]] Box room_of(const PointName& name);

/// A place beside its point for each name, the first names first: the nearest where it lies within
/// `area` and touches no other name and none of `kept_free`; nothing where there is none within 12
/// lines.
[[nodiscard]] std::vector<std::optional<Box>> places_of(const std::vector<PointName>& names,
                                                        const Box& area,
                                                        const std::vector<Box>& kept_free);

}  // namespace obscura::analysis
