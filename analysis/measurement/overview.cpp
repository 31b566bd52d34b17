// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/measurement/pareto.h"
#include "analysis/table/csv.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

CostAndError price_of(const OverviewRow& row) { return {row.ms + row.layer_ms, row.rmse}; }

/// A number of so many places behind the point; empty where there is none.
std::string places(double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "";
}

/// How many rows of the hard cases hold, of how many, and why others may not: `210/236, 26 by
/// nature`; empty where none was run.
std::string hard_cases_of(const OverviewRow& row) {
    if (row.hard_rows == 0) return "";
    std::string cell = fmt::format("{}/{}", row.hard_held, row.hard_rows);
    if (row.hard_by_nature > 0) cell += fmt::format(", {} by nature", row.hard_by_nature);
    return cell;
}

std::vector<std::string> cells_of(const OverviewRow& row) {
    return {row.variant,
            row.values,
            row.denoise,
            row.open_planes,
            row.fails,
            hard_cases_of(row),
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
    "variant",         "values", "filter",     "open planes", "fails",
    "hard cases hold", "RMSE",   "bias",       "p99",         "ms",
    "2nd layer",       "ratio",  "fetches/px", "bytes/px",    "front"};

}  // namespace

void finish_overview(std::vector<OverviewRow>& rows) {
    const auto yardstick = std::find_if(rows.begin(), rows.end(), [](const OverviewRow& row) {
        return row.variant == kYardstick && row.values != kFittedValues;
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
    std::string text =
        csv_line({"variant", "technique", "values", "blur", "open_planes", "fails",
                  "hard_cases_held", "hard_cases_by_nature", "hard_cases", "rmse", "bias", "p99",
                  "ms", "second_layer_ms", "ratio", "fetches_per_px", "bytes_per_px", "on_front"});
    const auto number = [](double value) {
        return std::isfinite(value) ? shortest(value) : std::string();
    };
    const auto count = [](int rows_of_cases, const OverviewRow& row) {
        return row.hard_rows > 0 ? std::to_string(rows_of_cases) : std::string();
    };
    for (const OverviewRow& row : rows) {
        text += csv_line({row.variant, row.technique, row.values, row.denoise, row.open_planes,
                          row.fails, count(row.hard_held, row), count(row.hard_by_nature, row),
                          count(row.hard_rows, row), number(row.rmse), number(row.bias),
                          number(row.p99), number(row.ms), number(row.layer_ms), number(row.ratio),
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

}  // namespace obscura::analysis
