// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "analysis/measurement/pareto.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

/// Okabe and Ito's colours, in an order that keeps neighbours apart.
constexpr std::array kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                              "#E69F00", "#56B4E9", "#000000", "#999999"};

/// A text as gnuplot takes it in double quotes, with no letter that means something there.
std::string quoted(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        const bool plain = static_cast<unsigned char>(letter) >= ' ' && letter != '"' &&
                           letter != '\\' && letter != '`' && letter != '$';
        safe += plain ? letter : ' ';
    }
    return '"' + safe + '"';
}

std::string file_stem(std::string text) {
    for (char& letter : text) {
        const bool safe = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                          (letter >= '0' && letter <= '9');
        if (!safe) letter = '-';
    }
    return text;
}

struct Point {
    double cost;
    double rmse;
    int samples;
};

/// A row without cost, as `none`, has no place on log axes.
bool has_place(const MeasurementRow& row) {
    return row.error.has_value() && row.cost.median_ms > 0.0 && row.error->rmse > 0.0;
}

/// The points that one line joins: a technique with the same parameters, fitted or not.
struct Series {
    std::string technique;
    bool fitted = false;
    std::map<std::string, double> parameters;
    std::string label;    ///< the technique's name; where it has several, the variant's
    std::string variant;  ///< of its points the name that says most
    std::vector<Point> points;

    [[nodiscard]] bool holds(const MeasurementRow& row) const {
        return row.technique == technique && row.fitted == fitted && row.parameters == parameters;
    }
};

/// What a row's time is held against: that of Blizzard24 as published with the filter, which holds
/// on other machines too; nothing where it was not measured.
std::optional<double> yardstick_ms(const std::vector<MeasurementRow>& rows,
                                   const std::string& denoise) {
    for (const MeasurementRow& row : rows) {
        const bool is_it = row.technique == "blizzard" && row.samples == 24 && !row.fitted &&
                           row.denoise == denoise && row.options.empty();
        if (is_it && row.cost.median_ms > 0.0) return row.cost.median_ms;
    }
    return std::nullopt;
}

std::vector<Series> series_of(const std::vector<MeasurementRow>& rows, const std::string& denoise,
                              double unit_ms) {
    std::vector<Series> all;
    for (const MeasurementRow& row : rows) {
        if (row.denoise != denoise || !has_place(row)) continue;
        auto series = std::find_if(all.begin(), all.end(),
                                   [&](const Series& known) { return known.holds(row); });
        if (series == all.end()) {
            all.push_back({row.technique, row.fitted, row.parameters, row.technique, "", {}});
            series = all.end() - 1;
        }
        if (row.variant.size() > series->variant.size()) series->variant = row.variant;
        series->points.push_back({row.cost.median_ms / unit_ms, row.error->rmse, row.samples});
    }
    for (Series& series : all) {
        const auto alike = std::count_if(all.begin(), all.end(), [&](const Series& other) {
            return other.technique == series.technique && other.fitted == series.fitted;
        });
        if (alike > 1) series.label = series.variant;
        std::stable_sort(series.points.begin(), series.points.end(),
                         [](const Point& a, const Point& b) { return a.samples < b.samples; });
    }
    return all;
}

/// Blocks of one data file, each named for `index`.
class Blocks {
  public:
    void add(const std::string& name, const std::vector<std::string>& lines) {
        if (!text_.empty()) text_ += "\n\n";
        text_ += "# " + name + '\n';
        for (const std::string& line : lines) text_ += line + '\n';
    }
    [[nodiscard]] std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

std::vector<std::string> lines_of(const std::vector<Point>& points) {
    std::vector<std::string> lines;
    for (const Point& point : points) {
        lines.push_back(
            fmt::format("{}\t{}\t{}", shortest(point.cost), shortest(point.rmse), point.samples));
    }
    return lines;
}

/// Every technique's line, the front, the rings: what is plotted, and the data that it reads.
class ErrorOverTime {
  public:
    ErrorOverTime(const std::vector<MeasurementRow>& rows, const std::string& denoise,
                  std::string file)
        : rows_(rows),
          denoise_(denoise),
          yardstick_ms_(yardstick_ms(rows, denoise)),
          unit_ms_(yardstick_ms_.value_or(1.0)),
          file_(std::move(file)) {}

    [[nodiscard]] Plot draw() {
        std::vector<std::string> techniques;
        for (const Series& series : series_of(rows_, denoise_, unit_ms_)) {
            auto at = std::find(techniques.begin(), techniques.end(), series.technique);
            if (at == techniques.end()) at = techniques.insert(at, series.technique);
            add_line(series, static_cast<std::size_t>(at - techniques.begin()));
        }
        add_front();
        add_rings();
        Plot plot;
        plot.script = fmt::format(
            "set logscale xy\nset xlabel {}\n"
            "set ylabel \"RMSE against the ray-traced truth (accessibility, 0 to 1)\"\n"
            "set key outside right top\nset grid xtics ytics lc rgb \"#dddddd\"\n"
            "set format y \"%g\"\nset format x \"%g\"\n{}plot {}\n",
            quoted(yardstick_ms_
                       ? fmt::format("time of accessibility and filter, of Blizzard24's {:.1f} ms",
                                     *yardstick_ms_)
                       : "median time of accessibility and filter (ms)"),
            ranges(), fmt::join(curves_, ", \\\n     "));
        plot.data.push_back({file_, blocks_.take()});
        return plot;
    }

  private:
    void add_curve(const std::string& block, const std::vector<std::string>& lines,
                   const std::string& style, const std::string& title) {
        if (lines.empty()) return;
        blocks_.add(block, lines);
        curves_.push_back(fmt::format("\"{}\" index \"{}\" {} {}", file_, block, style,
                                      title.empty() ? "notitle" : "title " + quoted(title)));
    }

    /// Techniques differ in colour and shape, filled before a fit, open when fitted.
    void add_line(const Series& series, std::size_t index) {
        constexpr std::array kFilled{7, 5, 9, 11, 13};  // gnuplot's circle, square, triangles ...
        const int shape = kFilled[index % kFilled.size()] - (series.fitted ? 1 : 0);
        add_curve(
            fmt::format("line_{}_{}{}", ++lines_, series.technique, series.fitted ? "_fitted" : ""),
            lines_of(series.points),
            fmt::format("using 1:2 with linespoints lc rgb \"{}\" lw 2 pt {} ps 0.8 dt {}",
                        kColours[index % kColours.size()], shape, series.fitted ? 2 : 1),
            series.label + (series.fitted ? ", fitted" : ""));
    }

    /// Limits of both axes around what is drawn.
    [[nodiscard]] std::string ranges() const {
        double cheapest = std::numeric_limits<double>::infinity();
        double dearest = 0.0;
        double smallest = std::numeric_limits<double>::infinity();
        double largest = 0.0;
        for (const MeasurementRow& row : rows_) {
            if (!has_place(row)) continue;
            cheapest = std::min(cheapest, row.cost.median_ms / unit_ms_);
            dearest = std::max(dearest, row.cost.median_ms / unit_ms_);
            smallest = std::min(smallest, row.error->rmse);
            largest = std::max(largest, row.error->rmse);
        }
        if (dearest == 0.0) return "";
        return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", shortest(cheapest / 1.2),
                           shortest(dearest * 1.2), shortest(smallest / 1.1),
                           shortest(largest * 1.1));
    }

    void add_front() {
        std::vector<CostAndError> all;
        for (const MeasurementRow& row : rows_) {
            if (has_place(row)) {
                all.push_back({row.cost.median_ms / unit_ms_, row.error->rmse});
            }
        }
        std::vector<std::string> lines;
        for (const CostAndError& choice : pareto_front(all)) {
            lines.push_back(fmt::format("{}\t{}", shortest(choice.cost), shortest(choice.error)));
        }
        add_curve("front", lines, "using 1:2 with steps lc rgb \"#000000\" lw 1",
                  "Pareto front, all filters");
    }

    void add_rings() {
        std::vector<std::string> lines;
        std::set<std::string> named;
        for (const MeasurementRow& row : rows_) {
            const bool drawn =
                !row.published.empty() && !row.fitted && row.denoise == denoise_ && has_place(row);
            if (!drawn || !named.insert(row.variant).second) continue;
            lines.push_back(fmt::format("{}\t{}\t{}", shortest(row.cost.median_ms / unit_ms_),
                                        shortest(row.error->rmse), quoted(row.variant)));
        }
        if (lines.empty()) return;
        add_curve("shown", lines, "using 1:2 with points pt 6 ps 2 lw 2 lc rgb \"#000000\"",
                  "shown in the study");
        curves_.push_back(fmt::format(
            "\"{}\" index \"shown\" using 1:2:3 with labels offset 0,1.1 font \",10\" notitle",
            file_));
    }

    const std::vector<MeasurementRow>& rows_;
    const std::string& denoise_;
    std::optional<double> yardstick_ms_;
    double unit_ms_;
    std::string file_;
    Blocks blocks_;
    std::vector<std::string> curves_;
    int lines_ = 0;
};

}  // namespace

Plot error_over_time(const std::vector<MeasurementRow>& rows, const std::string& denoise) {
    const std::string view = rows.empty() ? "nothing" : view_name(rows.front());
    const std::string name =
        "error-over-time-" + file_stem(rows.empty()
                                           ? view
                                           : rows.front().scene_id + ' ' + rows.front().camera +
                                                 ' ' + rows.front().validity);
    Plot plot = ErrorOverTime(rows, denoise, name + ".dat").draw();
    plot.name = name;
    plot.title = fmt::format("Speed against error: {} (filter: {})", view, denoise);
    return plot;
}

Plot growth_plot(const std::vector<Growth>& growths, const std::string& quantity) {
    Plot plot;
    plot.name = "growth-" + file_stem(quantity);
    plot.title = "Time of the accessibility pass over " + quantity;
    const std::string file = plot.name + ".dat";
    Blocks blocks;
    std::vector<std::string> curves;
    for (const Growth& growth : growths) {
        if (growth.quantity != quantity) continue;
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < growth.x.size(); ++i) {
            lines.push_back(shortest(growth.x[i]) + '\t' + shortest(growth.ms[i]));
        }
        blocks.add(growth.technique, lines);
        const std::string title =
            growth.law.has_value()
                ? fmt::format("{}: exponent {:.2f} ({:.2f} to {:.2f})", growth.technique,
                              growth.law->exponent, growth.law->low, growth.law->high)
                : growth.technique;
        curves.push_back(fmt::format(
            "\"{}\" index \"{}\" using 1:2 with linespoints lc rgb \"{}\" lw 2 pt 7 ps 0.6 title "
            "{}",
            file, growth.technique, kColours[curves.size() % kColours.size()], quoted(title)));
    }
    plot.script = fmt::format(
        "set logscale xy\nset xlabel {}\nset ylabel \"median time (ms)\"\nset key left top\n"
        "set grid xtics ytics lc rgb \"#dddddd\"\nset format y \"%g\"\nplot {}\n",
        quoted(quantity),
        curves.empty() ? "NaN notitle" : fmt::format("{}", fmt::join(curves, ", ")));
    plot.data.push_back({file, blocks.take()});
    return plot;
}

}  // namespace obscura::analysis
