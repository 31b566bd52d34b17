// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analysis/measurement/overview.h"
#include "analysis/measurement/pareto.h"
#include "analysis/plot/labels.h"
#include "analysis/table/csv.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

constexpr int kWidth_px = 1000;
constexpr int kHeight_px = 600;
/// What the axes enclose, in shares of the picture, so that names can be placed in pixels.
constexpr Box kGraph{0.08, 0.12, 0.895, 0.78};
/// The corner that the key takes, in pixels.
constexpr Box kKey{730.0, 440.0, 270.0, 160.0};
constexpr double kMark_px = 13.0;

/// Where a row is drawn; nothing without time or error.
bool is_drawn(const OverviewRow& row) {
    return std::isfinite(row.ratio) && row.ratio > 0.0 && std::isfinite(row.rmse);
}

/// Smallest and largest of what is drawn.
struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void hold(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// What the axes span: time in a logarithmic scale, error in a linear one.
struct Axes {
    Range time;
    Range error;

    [[nodiscard]] double x_px(double ratio) const {
        const double share = std::log(ratio / time.low) / std::log(time.high / time.low);
        return kWidth_px * (kGraph.left + kGraph.width * share);
    }
    [[nodiscard]] double y_px(double rmse) const {
        const double share = (rmse - error.low) / (error.high - error.low);
        return kHeight_px * (kGraph.bottom + kGraph.height * share);
    }
};

Axes axes_of(const std::vector<OverviewRow>& rows) {
    Axes axes;
    for (const OverviewRow& row : rows) {
        if (!is_drawn(row)) continue;
        axes.time.hold(row.ratio);
        axes.error.hold(row.rmse);
    }
    const double span = std::max(axes.error.high - axes.error.low, 1.0e-3);
    axes.time = {axes.time.low / 1.2, axes.time.high * 1.7};
    axes.error = {std::max(0.0, axes.error.low - 0.1 * span), axes.error.high + 0.08 * span};
    return axes;
}

/// Names of the rows of the front, then of each technique the first other as published: of each
/// technique one, or nothing could be read.
struct Names {
    std::vector<PointName> list;
    std::size_t of_the_front = 0;
};

Names names_of(const std::vector<OverviewRow>& rows, const Axes& axes) {
    constexpr double kFront_px = 15.0;  // 11 points
    constexpr double kOther_px = 12.0;  // 9 points
    Names names;
    std::vector<PointName> others;
    std::set<std::string> named;
    for (const OverviewRow& row : rows) {
        if (!is_drawn(row)) continue;
        const PointName name{axes.x_px(row.ratio), axes.y_px(row.rmse), row.variant,
                             row.on_front ? kFront_px : kOther_px};
        if (row.on_front) {
            names.list.push_back(name);
        } else if (row.values != kFittedValues && named.insert(row.technique).second) {
            others.push_back(name);
        }
    }
    names.of_the_front = names.list.size();
    names.list.insert(names.list.end(), others.begin(), others.end());
    return names;
}

/// The rows of the front, the cheapest first.
std::vector<CostAndError> front_of(const std::vector<OverviewRow>& rows) {
    std::vector<CostAndError> front;
    for (const OverviewRow& row : rows) {
        if (is_drawn(row) && row.on_front) front.push_back({row.ratio, row.rmse});
    }
    return pareto_front(front);
}

/// What the line of the front covers: to the right, then down.
std::vector<Box> line_of(const std::vector<CostAndError>& front, const Axes& axes) {
    constexpr double kWide_px = 6.0;
    std::vector<Box> line;
    for (std::size_t i = 1; i < front.size(); ++i) {
        const double left = axes.x_px(front[i - 1].cost);
        const double right = axes.x_px(front[i].cost);
        const double high = axes.y_px(front[i - 1].error);
        const double low = axes.y_px(front[i].error);
        line.push_back({left, high - 0.5 * kWide_px, right - left, kWide_px});
        line.push_back({right - 0.5 * kWide_px, low, kWide_px, high - low});
    }
    return line;
}

/// A place of the picture as gnuplot takes it.
std::string screen(double x_px, double y_px) {
    return fmt::format("screen {:.4f},{:.4f}", x_px / kWidth_px, y_px / kHeight_px);
}

/// The names where none touches another or the line, with a line to the point where that is not
/// close by.
std::string labels_of(const std::vector<OverviewRow>& rows, const Axes& axes) {
    constexpr double kClose_px = 12.0;
    std::vector<Box> kept_free{kKey, {95.0, 80.0, 70.0, 30.0}};  // the other: "better"
    for (const OverviewRow& row : rows) {
        if (!is_drawn(row)) continue;
        kept_free.push_back({axes.x_px(row.ratio) - 0.5 * kMark_px,
                             axes.y_px(row.rmse) - 0.5 * kMark_px, kMark_px, kMark_px});
    }
    const std::vector<Box> line = line_of(front_of(rows), axes);
    kept_free.insert(kept_free.end(), line.begin(), line.end());
    const Box area{kWidth_px * kGraph.left, kHeight_px * kGraph.bottom, kWidth_px * kGraph.width,
                   kHeight_px * kGraph.height};
    const Names names = names_of(rows, axes);
    const auto places = places_of(names.list, area, kept_free);
    std::string script;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i]) continue;
        const PointName& name = names.list[i];
        const Box& box = *places[i];
        const bool front = i < names.of_the_front;
        const double near_x = std::clamp(name.x, box.left, box.left + box.width);
        const double near_y = std::clamp(name.y, box.bottom, box.bottom + box.height);
        if (std::hypot(near_x - name.x, near_y - name.y) > kClose_px) {
            script += fmt::format("set arrow from {} to {} nohead lc rgb \"#aaaaaa\" lw 1\n",
                                  screen(name.x, name.y), screen(near_x, near_y));
        }
        script +=
            fmt::format("set label {} at {} left font \",{}\" textcolor rgb \"{}\"\n",
                        gnuplot_text(name.text), screen(box.left, box.bottom + 0.5 * box.height),
                        front ? 11 : 9, front ? "#000000" : "#777777");
    }
    return script;
}

std::string block(const std::string& name, const std::vector<std::string>& lines) {
    return fmt::format("# {}\n{}\n\n\n", name, fmt::join(lines, "\n"));
}

std::string point(double time, double error) {
    return fmt::format("{}\t{}", shortest(time), shortest(error));
}

}  // namespace

Plot overview_chart(const std::vector<OverviewRow>& rows) {
    std::vector<std::string> published;
    std::vector<std::string> fitted;
    for (const OverviewRow& row : rows) {
        if (!is_drawn(row)) continue;
        (row.values == kFittedValues ? fitted : published).push_back(point(row.ratio, row.rmse));
    }
    std::vector<std::string> steps;
    for (const CostAndError& price : front_of(rows)) {
        steps.push_back(point(price.cost, price.error));
    }
    Plot plot;
    plot.name = "front";
    plot.title = "Ambient occlusion: how near to the truth, for how much time";
    plot.width_px = kWidth_px;
    plot.height_px = kHeight_px;
    const std::string file = plot.name + ".dat";
    std::string data;
    std::vector<std::string> curves;
    const auto add = [&](const std::string& name, const std::vector<std::string>& lines,
                         const std::string& style) {
        if (lines.empty()) return;
        data += block(name, lines);
        curves.push_back(fmt::format("\"{}\" index \"{}\" using {}", file, name, style));
    };
    add("steps", steps, "1:2 with steps lc rgb \"#009E73\" lw 2 title \"the best for their time\"");
    add("published", published,
        "1:2 with points pt 6 ps 1.2 lw 2 lc rgb \"#666666\" title \"as published\"");
    add("fitted", fitted, "1:2 with points pt 7 ps 1.3 lc rgb \"#0072B2\" title \"fitted\"");
    if (!curves.empty()) {
        const Axes axes = axes_of(rows);
        plot.script = fmt::format(
            "set logscale x 2\nset xlabel \"time of accessibility and filter, {} = 1\"\n"
            "set ylabel \"error (RMSE of accessibility, 0 to 1)\"\n"
            "set lmargin at screen {}\nset rmargin at screen {}\n"
            "set bmargin at screen {}\nset tmargin at screen {}\n"
            "set xrange [{}:{}]\nset yrange [{}:{}]\nset format x \"%g\"\nset format y \"%g\"\n"
            "set key inside right top\nset grid xtics ytics lc rgb \"#dddddd\"\n"
            "set label \"better\" at graph 0.03,0.05 font \",12\" textcolor rgb \"#009E73\"\n",
            kYardstick, kGraph.left, kGraph.left + kGraph.width, kGraph.bottom,
            kGraph.bottom + kGraph.height, shortest(axes.time.low), shortest(axes.time.high),
            shortest(axes.error.low), shortest(axes.error.high));
        plot.script += labels_of(rows, axes);
    }
    plot.script += fmt::format(
        "plot {}\n",
        curves.empty() ? "NaN notitle" : fmt::format("{}", fmt::join(curves, ", \\\n     ")));
    plot.data.push_back({file, data});
    return plot;
}

}  // namespace obscura::analysis
