// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/report_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace obscura::analysis {
namespace {

/// Points of a series of its own each: fourteen shapes, so that also those can be told apart that
/// share one of the eight colours.
constexpr std::array<int, 14> kShapes{7, 9, 5, 6, 13, 8, 4, 12, 11, 15, 2, 10, 1, 14};
constexpr int kRow_px = 27;
constexpr int kAround_px = 225;  ///< title, axis and key

/// Commands for the words on both sides of a dividing line.
std::string sides_of(const IntervalPlot& plot) {
    if (!plot.has_line) return "";
    std::string script = fmt::format(
        "set arrow from first {0:g}, graph 0 to first {0:g}, graph 1 nohead lc rgb \"#000000\" "
        "lw 1.5 dt (6,5)\n",
        plot.line);
    if (!plot.left.empty()) {
        script += fmt::format("set label {} at first {:g}, graph 1 right offset -1,0.8\n",
                              gnuplot_text("← " + plot.left), plot.line);
    }
    if (!plot.right.empty()) {
        script += fmt::format("set label {} at first {:g}, graph 1 left offset 1,0.8\n",
                              gnuplot_text(plot.right + " →"), plot.line);
    }
    return script;
}

std::string rows_of(const IntervalPlot& plot, std::size_t group) {
    std::string text;
    for (std::size_t i = 0; i < plot.rows.size(); ++i) {
        const IntervalRow& row = plot.rows[i];
        if (row.group != group || !row.has_value) continue;
        text += fmt::format("{}\t{:.9g}\t{:.9g}\t{:.9g}\t{}\n", i + 1, row.value, row.low, row.high,
                            plot_cell(row.label));
    }
    return text;
}

std::size_t longest_note(const IntervalPlot& plot) {
    std::size_t longest = 0;
    for (const IntervalRow& row : plot.rows) longest = std::max(longest, row.note.size());
    return longest;
}

/// The names of the rows on the left and their notes on the right.
std::string names_of(const IntervalPlot& plot) {
    std::string tics;
    std::string script;
    for (std::size_t i = 0; i < plot.rows.size(); ++i) {
        tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_text(plot.rows[i].label), i + 1);
        if (plot.rows[i].note.empty()) continue;
        script += fmt::format("set label {} at graph 1, first {} left offset 1.5,0\n",
                              gnuplot_text(plot.rows[i].note), i + 1);
    }
    return fmt::format("set ytics ({}) scale 0\n", tics) + script;
}

std::string range_of(const std::string& axis, double low, double high) {
    if (!(low < high)) return "";
    return fmt::format("set {}range [{:g}:{:g}]\n", axis, low, high);
}

std::string header(std::string_view columns) { return fmt::format("# {}\n", columns); }

/// The groups that have rows, in their order.
std::vector<std::size_t> used_groups(const IntervalPlot& plot) {
    std::vector<std::size_t> groups;
    for (const IntervalRow& row : plot.rows) {
        if (row.has_value) groups.push_back(row.group);
    }
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    return groups;
}

}  // namespace

Plot interval_plot(const IntervalPlot& all) {
    IntervalPlot plot = all;
    if (plot.rows.size() > kMostRows) {
        plot.axis += fmt::format(" (the first {} of {})", kMostRows, plot.rows.size());
        plot.rows.resize(kMostRows);
    }
    Plot drawn;
    drawn.name = plot.name;
    drawn.title = plot.title;
    drawn.height_px = kAround_px + kRow_px * static_cast<int>(plot.rows.size());
    const std::string file = plot.name + ".tsv";
    std::string data = header("row\tvalue\tlow\thigh\tlabel; a block for each group");
    std::string commands;
    const std::vector<std::size_t> groups = used_groups(plot);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (i > 0) data += "\n\n";
        data += rows_of(plot, groups[i]);
        const std::string title =
            groups.size() > 1 && groups[i] < plot.groups.size()
                ? fmt::format("title {}", gnuplot_text(plot.groups[groups[i]]))
                : "notitle";
        commands += fmt::format("{}{} index {} using 2:1:3:4 with xerrorbars lt {} {}",
                                i == 0 ? "plot " : ", \\\n     ", gnuplot_text(file), i,
                                groups[i] + 1, title);
    }
    // A plot of nothing at all would be an error.
    if (groups.empty()) commands = "plot NaN notitle";
    drawn.data = {{file, data}};
    drawn.script = fmt::format(
        "set key below center horizontal height 1\nset bars 0.6\nset yrange [{}.6:0.4]\n"
        "set title offset 0,1\nset tmargin {}\nset xlabel {}\nset rmargin {}\n",
        plot.rows.size(), plot.left.empty() ? 3 : 5, gnuplot_text(plot.axis),
        longest_note(plot) + 4);
    drawn.script +=
        range_of("x", plot.x_low, plot.x_high) + sides_of(plot) + names_of(plot) + commands + '\n';
    return drawn;
}

Plot curve_plot(const CurvePlot& plot) {
    Plot drawn;
    drawn.name = plot.name;
    drawn.title = plot.title;
    const std::string file = plot.name + ".tsv";
    std::string data = header("x\ty\tlabel; a block for each series");
    std::string commands;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& series = plot.series[i];
        data += fmt::format("{}# {}\n", i == 0 ? "" : "\n\n", series.title);
        for (std::size_t k = 0; k < series.points.size(); ++k) {
            data += fmt::format("{:.9g}\t{:.9g}", series.points[k].first, series.points[k].second);
            if (k < series.labels.size()) data += '\t' + plot_cell(series.labels[k]);
            data += '\n';
        }
        if (series.points.empty()) continue;
        commands += fmt::format(
            "{}{} index {} using 1:2 with {} lt {} title {}",
            commands.empty() ? "plot " : ", \\\n     ", gnuplot_text(file), i,
            series.is_line ? "lines" : fmt::format("points pt {}", kShapes[i % kShapes.size()]),
            i % 8 + 1, gnuplot_text(series.title));
        if (!series.is_labelled) continue;
        commands += fmt::format(
            ", \\\n     {} index {} using 1:2:3 with labels left offset 0.8,0.4 font \",12\" "
            "notitle",
            gnuplot_text(file), i);
    }
    if (commands.empty()) commands = "plot NaN notitle";
    drawn.data = {{file, data}};
    drawn.script = fmt::format(
        "set xlabel {}\nset ylabel {}\nset key below center horizontal height 1\n{}{}\n",
        gnuplot_text(plot.x_axis), gnuplot_text(plot.y_axis), plot.extra, commands);
    return drawn;
}

Plot dependence_plot(const DependencePlot& plot) {
    Plot drawn;
    drawn.name = plot.name;
    drawn.title = plot.title;
    const std::string points_file = plot.name + "-points.tsv";
    const std::string curve_file = plot.name + "-curve.tsv";
    std::string curve = header("x\tshare B (%)\tlow\thigh");
    for (const auto& at : plot.curve) {
        curve += fmt::format("{:.9g}\t{:.9g}\t{:.9g}\t{:.9g}\n", at.x, 100.0 * at.share,
                             100.0 * at.low, 100.0 * at.high);
    }
    std::string points = header("x\tshare B (%)\tlow\thigh\tlabel; a block for each level");
    std::string commands;
    if (!plot.curve.empty()) {
        commands = fmt::format(
            "plot {0} using 1:3:4 with filledcurves fc rgb \"#DDDDDD\" title "
            "'fit, 95 % band', \\\n     {0} using 1:2 with lines lt 4 title 'fit'",
            gnuplot_text(curve_file));
    }
    int block = 0;
    for (std::size_t group = 0; group < plot.groups.size(); ++group) {
        std::string rows;
        for (const auto& point : plot.points) {
            if (point.group != group) continue;
            rows +=
                fmt::format("{:.9g}\t{:.9g}\t{:.9g}\t{:.9g}\t{}\n", point.x, 100.0 * point.share,
                            100.0 * point.low, 100.0 * point.high, plot_cell(point.label));
        }
        if (rows.empty()) continue;
        points += (block == 0 ? "" : "\n\n") + rows;
        commands += fmt::format(
            "{0}{1} index {2} using 1:2:3:4 with yerrorbars lt {3} title {4}, \\\n"
            "     {1} index {2} using 1:2:5 with labels left offset 0.8,0.5 font \",12\" notitle",
            commands.empty() ? "plot " : ", \\\n     ", gnuplot_text(points_file), block, group + 1,
            gnuplot_text(plot.groups[group]));
        ++block;
    }
    if (commands.empty()) commands = "plot NaN notitle";
    drawn.data = {{points_file, points}, {curve_file, curve}};
    drawn.script = fmt::format(
        "set xlabel {}\nset ylabel 'chose image B (%)'\nset yrange [0:100]\nset bars 0.6\n"
        "set key below center horizontal height 1\nset offsets graph 0.05, graph 0.08, 0, 0\n"
        "set arrow from graph 0, first 50 to graph 1, first 50 nohead lc rgb \"#000000\" dt (6,5)\n"
        "set arrow from first 0, graph 0 to first 0, graph 1 nohead lc rgb \"#999999\" dt (2,4)\n"
        "{}\n",
        gnuplot_text(plot.x_axis), commands);
    return drawn;
}

}  // namespace obscura::analysis
