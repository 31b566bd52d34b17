// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/plot/gnuplot.h"
#include "analysis/presentation/html.h"

namespace obscura::analysis {

/// One setting of one technique, its means over several views.
struct OverviewRow {
    std::string variant;  ///< Gtao16, with what of it is not as usual
    std::string technique;
    std::string values;  ///< published or fitted
    std::string denoise;
    std::string open_planes;  ///< which planes without an occluder are open: all, facing, none
    std::string fails;        ///< what else of a perfect accessibility it has not by its definition
    int hard_held = 0;        ///< of the technique's rows of the hard cases, those that hold
    int hard_by_nature = 0;   ///< and those that it fails by its definition
    int hard_rows = 0;        ///< of all; 0: they were not run
    double ms = 0.0;          ///< of accessibility and filter
    double layer_ms = 0.0;    ///< of a second layer's geometry beside them; 0: it has none
    double ratio = 0.0;       ///< of ms to the yardstick's; NaN: there is none
    int fetches_per_px = 0;
    double bytes_per_px = 0.0;  ///< of the buffers that technique and filter have for themselves
    double rmse = 0.0;          ///< root of the mean of the views' squared errors; NaN: no error
    double bias = 0.0;
    double p99 = 0.0;
    bool on_front = false;  ///< no other row is both quicker and nearer to the truth
};

/// What every ratio of time is taken to: the variant's name, as published.
inline constexpr const char* kYardstick = "Blizzard24";

/// OverviewRow::values of a row whose parameters a fit has found.
inline constexpr const char* kFittedValues = "fitted";

/// Fills in the ratios and marks the front. A second layer's geometry counts for the front.
void finish_overview(std::vector<OverviewRow>& rows);

/// One row a setting; what does not exist is an empty cell.
[[nodiscard]] std::string overview_csv(const std::vector<OverviewRow>& rows);
[[nodiscard]] std::string overview_text(const std::vector<OverviewRow>& rows);
[[nodiscard]] PageTable overview_table(const std::vector<OverviewRow>& rows);

/// Error over time in ratios, which hold on another machine: a point a row, open as published and
/// filled as fitted, and the front. Names have the rows of the front and, of each technique, the
/// first other as published, so that no two touch. The axes span what is drawn.
[[nodiscard]] Plot overview_chart(const std::vector<OverviewRow>& rows);

}  // namespace obscura::analysis
