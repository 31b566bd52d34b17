// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/plot/gnuplot.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// A value with its interval, on a line of its own.
struct IntervalRow {
    std::string label;      ///< left of the axis
    std::string note;       ///< right of the plot
    std::size_t group = 0;  ///< place in IntervalPlot::groups, which gives colour and shape
    bool has_value = false;
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// Values with intervals below each other, the first row on top.
struct IntervalPlot {
    std::string name;
    std::string title;
    std::string axis;                 ///< what the horizontal axis shows, with its unit
    std::vector<std::string> groups;  ///< for the key; one group needs none
    std::vector<IntervalRow> rows;
    bool has_line = false;  ///< a vertical line that divides, at `line`
    double line = 0.0;
    std::string left;    ///< what lies left of it, in words
    std::string right;   ///< what lies right of it
    double x_low = 0.0;  ///< of the axis; equal ends: from the data
    double x_high = 0.0;
};

/// More rows than this make no picture that anyone could read; the table has them all.
inline constexpr std::size_t kMostRows = 100;

/// Its height grows with the rows; of more than kMostRows the first are drawn, and the axis says
/// so.
[[nodiscard]] Plot interval_plot(const IntervalPlot& all);

/// A line through points, or points alone.
struct Series {
    std::string title;
    std::vector<std::pair<double, double>> points;
    bool is_line = true;
    bool is_labelled = false;         ///< the points' `labels` are written beside them
    std::vector<std::string> labels;  ///< as many as points where `is_labelled`
};

/// Series over two axes, each series with a colour, dash and shape of its own.
struct CurvePlot {
    std::string name;
    std::string title;
    std::string x_axis;  ///< with its unit
    std::string y_axis;
    std::vector<Series> series;
    std::string extra;  ///< gnuplot commands before the plot: ranges, arrows, logarithmic axes
};

[[nodiscard]] Plot curve_plot(const CurvePlot& plot);

/// Shares with intervals over a measured difference, and a curve with its band.
struct DependencePlot {
    std::string name;
    std::string title;
    std::string x_axis;
    std::vector<std::string> groups;  ///< of the points: the levels of validity
    struct Point {
        std::string label;
        std::size_t group = 0;
        double x = 0.0;
        double share = 0.0;  ///< all shares 0 to 1
        double low = 0.0;
        double high = 0.0;
    };
    std::vector<Point> points;
    struct Band {
        double x = 0.0;
        double share = 0.0;
        double low = 0.0;
        double high = 0.0;
    };
    std::vector<Band> curve;  ///< empty where no curve was fitted
};

[[nodiscard]] Plot dependence_plot(const DependencePlot& plot);

}  // namespace obscura::analysis
