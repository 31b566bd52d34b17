// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/measurement/growth.h"
#include "analysis/measurement/row.h"
#include "analysis/plot/gnuplot.h"

namespace obscura::analysis {

/// Error over time of one view: a line for each technique over its samples with the filter
/// `denoise`, solid as published and dashed fitted, the Pareto front of all rows, and a ring with
/// the variant's name around each setting that the study shows; time over that of Blizzard24 where
/// the rows have it. The axes span what is drawn. `rows` are of one view.
[[nodiscard]] Plot error_over_time(const std::vector<MeasurementRow>& rows,
                                   const std::string& denoise);

/// Time of the accessibility pass over one quantity, a line a technique, on log axes.
[[nodiscard]] Plot growth_plot(const std::vector<Growth>& growths, const std::string& quantity);

/// measured - truth at each pixel as an image with a scale bar: blue is too dark, white right,
/// vermilion too light (Okabe and Ito's colours, told apart by every kind of colour vision).
struct ErrorMap {
    std::string name;  ///< stem of the files
    std::string title;
    int width = 0;
    int height = 0;
    std::vector<float> difference;  ///< upper row first; what is not finite is drawn black
    double limit = 0.5;             ///< what lies beyond +-limit has the colour of the end
};

/// Throws bad input where the number of pixels does not fit.
[[nodiscard]] Plot error_map(const ErrorMap& map);

}  // namespace obscura::analysis
