// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/screen_columns.h"

#include <nlohmann/json.hpp>

#include "analysis/export/member_cells.h"

namespace obscura::analysis {

std::optional<double> screen_fact(const SessionRecord& session, const char* name) {
    const auto timing = nlohmann::json::parse(session.timing, nullptr, false);
    if (!timing.is_object() || !timing.contains("screen")) return std::nullopt;
    const auto& screen = timing["screen"];
    if (!screen.is_object() || !screen.contains(name) || !screen[name].is_number()) {
        return std::nullopt;
    }
    return screen[name].get<double>();
}

std::vector<ExportColumn<SessionRow>> screen_columns() {
    struct Fact {
        const char* name;
        const char* description;
        const char* units;
    };
    constexpr Fact kFacts[]{
        {"viewing_distance_cm",
         "Distance from eye to screen, as the operator said; empty: not said", "cm"},
        {"screen_width_cm",
         "Width of what is lit of the screen, as the operator said; empty: not "
         "said",
         "cm"},
        {"screen_height_cm",
         "Height of what is lit of the screen, as the operator said; empty: "
         "not said",
         "cm"},
        {"luminance_cd_m2", "Luminance of white, as the operator measured; empty: not said",
         "cd/m2"},
        {"gamma", "Exponent of the monitor, as the operator measured; empty: not said", ""},
        {"image_width_deg",
         "Width of an image, by distance and size of the screen; empty: these "
         "were not said",
         "deg"},
        {"image_height_deg",
         "Height of an image, by distance and size of the screen; empty: "
         "these were not said",
         "deg"},
        {"pixels_per_degree",
         "Pixels in a degree of visual angle in the middle of the screen; "
         "empty: distance and size were not said",
         "1/deg"},
    };
    std::vector<ExportColumn<SessionRow>> columns;
    for (const Fact& fact : kFacts) {
        const char* const name = fact.name;
        columns.push_back({name,
                           fact.description,
                           {},
                           fact.units,
                           {[name](const SessionRow& row, std::string& out) {
                                append_cell(out, screen_fact(*row.session, name));
                            },
                            true}});
    }
    return columns;
}

}  // namespace obscura::analysis
