// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/fitted_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "analysis/table/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::app::explorer {
namespace {

/// Where the columns are that are read; others may stand beside them.
struct Columns {
    std::size_t scene, technique, parameter, fitted, rmse;
};

Columns columns_of(const analysis::CsvRecord& head, const std::string& name) {
    const auto at = [&](const char* column) {
        const auto found = std::find(head.fields.begin(), head.fields.end(), column);
        if (found == head.fields.end()) {
            throw base::bad_input("{}:{}: there is no column {}", name, head.line, column);
        }
        return static_cast<std::size_t>(found - head.fields.begin());
    };
    return {at("scene"), at("technique"), at("parameter"), at("fitted"),
            at("training_rmse_fitted")};
}

double number_in(const std::string& text, const std::string& name, int line) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        throw base::bad_input("{}:{}: fitted is \"{}\"; allowed is a finite number", name, line,
                              text);
    }
    return value;
}

}  // namespace

std::vector<FittedValues> read_fitted_values(const std::filesystem::path& file) {
    std::vector<FittedValues> all;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return all;
    const std::string name = file.string();
    const auto records = analysis::parse_csv(base::read_file(file), name);
    if (records.empty()) return all;
    const Columns columns = columns_of(records.front(), name);
    for (std::size_t i = 1; i < records.size(); ++i) {
        const auto& [line, fields] = records[i];
        if (fields.size() != records.front().fields.size()) {
            throw base::bad_input("{}:{}: {} fields; the first line has {}", name, line,
                                  fields.size(), records.front().fields.size());
        }
        const std::string& scene = fields[columns.scene];
        const std::string& technique = fields[columns.technique];
        auto found = std::find_if(all.begin(), all.end(), [&](const FittedValues& values) {
            return values.scene == scene && values.technique == technique;
        });
        const std::string& parameter = fields[columns.parameter];
        // Of several fits of one technique the first counts.
        if (found != all.end() && found->parameters.contains(parameter)) continue;
        if (found == all.end()) {
            found = all.insert(all.end(), {scene, technique, {}, fields[columns.rmse]});
        }
        found->parameters[parameter] = number_in(fields[columns.fitted], name, line);
    }
    return all;
}

}  // namespace obscura::app::explorer
