// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/overview.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analysis/measurement/pareto.h"
#include "analysis/table/csv.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

constexpr const char* kFitted = "fitted";

CostAndError price_of(const OverviewRow& row) { return {row.ms + row.layer_ms, row.rmse}; }

/// A number of so many places behind the point; empty where there is none.
std::string places(double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "";
}

std::vector<std::string> cells_of(const OverviewRow& row) {
    return {row.variant,
            row.values,
            row.denoise,
            row.open_planes,
            row.fails,
            places(row.rmse, 4),
            std::isfinite(row.bias) ? fmt::format("{:+.3f}", row.bias) : "",
            places(row.p99, 3),
            places(row.ms, 2),
            row.layer_ms > 0.0 ? places(row.layer_ms, 2) : "",
            places(row.ratio, 3),
            std::to_string(row.fetches_per_px),
            places(row.bytes_per_px, 1),
            row.on_front ? "yes" : ""};
}

const std::vector<std::string> kHeadings{
    "variant", "values", "filter",    "open planes", "fails",      "RMSE",     "bias",
    "p99",     "ms",     "2nd layer", "ratio",       "fetches/px", "bytes/px", "front"};

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

std::string block(const std::string& name, const std::vector<std::string>& lines) {
    return fmt::format("# {}\n{}\n\n\n", name, fmt::join(lines, "\n"));
}

}  // namespace

void finish_overview(std::vector<OverviewRow>& rows) {
    const auto yardstick = std::find_if(rows.begin(), rows.end(), [](const OverviewRow& row) {
        return row.variant == kYardstick && row.values != kFitted;
    });
    const double unit_ms = yardstick != rows.end() && yardstick->ms > 0.0
                               ? yardstick->ms
                               : std::numeric_limits<double>::quiet_NaN();
    std::vector<CostAndError> prices;
    for (const OverviewRow& row : rows) {
        if (std::isfinite(row.rmse)) prices.push_back(price_of(row));
    }
    for (OverviewRow& row : rows) {
        row.ratio = row.ms / unit_ms;
        row.on_front = std::isfinite(row.rmse) && is_on_front(price_of(row), prices);
    }
}

std::string overview_csv(const std::vector<OverviewRow>& rows) {
    std::string text = csv_line({"variant", "technique", "values", "blur", "open_planes", "fails",
                                 "rmse", "bias", "p99", "ms", "second_layer_ms", "ratio",
                                 "fetches_per_px", "bytes_per_px", "on_front"});
    const auto number = [](double value) {
        return std::isfinite(value) ? shortest(value) : std::string();
    };
    for (const OverviewRow& row : rows) {
        text += csv_line({row.variant, row.technique, row.values, row.denoise, row.open_planes,
                          row.fails, number(row.rmse), number(row.bias), number(row.p99),
                          number(row.ms), number(row.layer_ms), number(row.ratio),
                          std::to_string(row.fetches_per_px), number(row.bytes_per_px),
                          row.on_front ? "true" : "false"});
    }
    return text;
}

PageTable overview_table(const std::vector<OverviewRow>& rows) {
    PageTable table;
    table.headings = kHeadings;
    for (const OverviewRow& row : rows) table.rows.push_back(cells_of(row));
    return table;
}

std::string overview_text(const std::vector<OverviewRow>& rows) {
    constexpr std::size_t kFails = 4;  // as long as a sentence: on the page and in the CSV file
    std::vector<std::vector<std::string>> lines{kHeadings};
    for (const OverviewRow& row : rows) lines.push_back(cells_of(row));
    std::vector<std::size_t> widths(kHeadings.size());
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], line[i].size());
    }
    std::string text;
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (i == kFails) continue;
            const bool left = i < kFails;
            text += left ? fmt::format("{:<{}}  ", line[i], widths[i])
                         : fmt::format("{:>{}}  ", line[i], widths[i]);
        }
        text += '\n';
    }
    return text;
}

Plot overview_chart(const std::vector<OverviewRow>& rows) {
    Range time;
    Range error;
    std::vector<std::string> published;
    std::vector<std::string> fitted;
    std::vector<std::string> front;
    std::vector<std::string> others;
    std::vector<CostAndError> prices;
    std::set<std::string> named;
    for (const OverviewRow& row : rows) {
        if (!is_drawn(row)) continue;
        time.hold(row.ratio);
        error.hold(row.rmse);
        const bool is_fitted = row.values == kFitted;
        const std::string line = fmt::format("{}\t{}\t{}", shortest(row.ratio), shortest(row.rmse),
                                             plot_cell(row.variant));
        (is_fitted ? fitted : published).push_back(line);
        if (row.on_front) {
            front.push_back(line);
            prices.push_back({row.ratio, row.rmse});
        } else if (!is_fitted && named.insert(row.technique).second) {
            others.push_back(line);  // of each technique one, or nothing could be read
        }
    }
    std::vector<std::string> steps;
    for (const CostAndError& price : pareto_front(prices)) {
        steps.push_back(fmt::format("{}\t{}", shortest(price.cost), shortest(price.error)));
    }
    Plot plot;
    plot.name = "front";
    plot.title = "Ambient occlusion: how near to the truth, for how much time";
    plot.width_px = 1000;
    plot.height_px = 600;
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
    add("best", front, "1:2:3 with labels left rotate by 35 offset 0.4,0.6 font \",11\" notitle");
    add("others", others,
        "1:2:3 with labels left offset 0.7,0.3 font \",9\" textcolor rgb \"#777777\" notitle");
    if (!curves.empty()) {
        plot.script = fmt::format(
            "set logscale x 2\nset xlabel \"time of accessibility and filter, {} = 1\"\n"
            "set ylabel \"error (RMSE of accessibility, 0 to 1)\"\n"
            "set xrange [{}:{}]\nset yrange [{}:{}]\nset format x \"%g\"\nset format y \"%g\"\n"
            "set key inside right top\nset grid xtics ytics lc rgb \"#dddddd\"\n"
            "set label \"better\" at graph 0.03,0.05 font \",12\" textcolor rgb \"#009E73\"\n",
            kYardstick, shortest(time.low / 1.2), shortest(time.high * 1.7),
            shortest(std::max(0.0, error.low - 0.1 * (error.high - error.low))),
            shortest(error.high + 0.08 * (error.high - error.low)));
    }
    plot.script += fmt::format(
        "plot {}\n",
        curves.empty() ? "NaN notitle" : fmt::format("{}", fmt::join(curves, ", \\\n     ")));
    plot.data.push_back({file, data});
    return plot;
}

}  // namespace obscura::analysis
