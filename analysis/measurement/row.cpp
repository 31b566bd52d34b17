// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/row.h"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "analysis/measurement/pareto.h"
#include "analysis/table/csv.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

using Json = nlohmann::ordered_json;

/// A cell: text, number, truth value, or null with the reason.
struct Cell {
    Json value;
    std::string reason;
};

struct Column {
    const char* name;
    std::function<Cell(const MeasurementRow&)> cell;
};

template <typename T>
Cell possible(const Possible<AccessibilityError>& error, T AccessibilityError::*member) {
    if (!error.has_value()) return {nullptr, error.reason};
    return {(*error).*member, ""};
}

Cell psnr(const Possible<AccessibilityError>& error) {
    if (!error.has_value()) return {nullptr, error.reason};
    if (!error->psnr_db.has_value()) return {nullptr, error->psnr_db.reason};
    return {*error->psnr_db, ""};
}

Cell image(const MeasurementRow& row, double FinalImageError::*member) {
    if (!row.image) return {nullptr, "no image was compared"};
    return {(*row.image).*member, ""};
}

std::string parameters_of(const MeasurementRow& row) {
    std::string text;
    for (const auto& [name, value] : row.parameters) {
        text += (text.empty() ? "" : ";") + name + '=' + shortest(value);
    }
    return text;
}

using Row = MeasurementRow;
using Error = AccessibilityError;

/// The columns that others rely on, in their order.
std::vector<Column> fixed_columns() {
    return {
        {"scene_id",
         [](const Row& r) -> Cell {
             return {r.scene_id, ""};
         }},
        {"scene",
         [](const Row& r) -> Cell {
             return {r.scene, ""};
         }},
        {"camera",
         [](const Row& r) -> Cell {
             return {r.camera, ""};
         }},
        {"validity",
         [](const Row& r) -> Cell {
             return {r.validity, ""};
         }},
        {"technique",
         [](const Row& r) -> Cell {
             return {r.technique, ""};
         }},
        {"samples",
         [](const Row& r) -> Cell {
             return {r.samples, ""};
         }},
        {"blur",
         [](const Row& r) -> Cell {
             return {r.denoise, ""};
         }},
        {"ao_scale",
         [](const Row& r) -> Cell {
             return {r.ao_scale, ""};
         }},
        {"depth_format",
         [](const Row& r) -> Cell {
             return {r.depth_format, ""};
         }},
        {"noise",
         [](const Row& r) -> Cell {
             return {r.noise, ""};
         }},
        {"width",
         [](const Row& r) -> Cell {
             return {r.width, ""};
         }},
        {"height",
         [](const Row& r) -> Cell {
             return {r.height, ""};
         }},
        {"device",
         [](const Row& r) -> Cell {
             return {r.device, ""};
         }},
        {"fitted",
         [](const Row& r) -> Cell {
             return {r.fitted, ""};
         }},
        {"ms_min",
         [](const Row& r) -> Cell {
             return {r.cost.min_ms, ""};
         }},
        {"ms_median",
         [](const Row& r) -> Cell {
             return {r.cost.median_ms, ""};
         }},
        {"ms_p95",
         [](const Row& r) -> Cell {
             return {r.cost.p95_ms, ""};
         }},
        {"fetches_per_px",
         [](const Row& r) -> Cell {
             return {r.fetches_per_px, ""};
         }},
        {"rmse", [](const Row& r) { return possible(r.error, &Error::rmse); }},
        {"bias", [](const Row& r) { return possible(r.error, &Error::bias); }},
        {"mae", [](const Row& r) { return possible(r.error, &Error::mae); }},
        {"p99", [](const Row& r) { return possible(r.error, &Error::p99); }},
        {"psnr_db", [](const Row& r) { return psnr(r.error); }},
        {"nonfinite",
         [](const Row& r) -> Cell {
             return {r.nonfinite, ""};
         }},
        {"on_front",
         [](const Row& r) -> Cell {
             return {r.on_front, ""};
         }},
    };
}

std::vector<Column> further_columns() {
    return {
        {"variant",
         [](const Row& r) -> Cell {
             return {r.variant, ""};
         }},
        {"values",
         [](const Row& r) -> Cell {
             return {r.values, ""};
         }},
        {"published",
         [](const Row& r) -> Cell {
             return {r.published, ""};
         }},
        {"parameters",
         [](const Row& r) -> Cell {
             return {parameters_of(r), ""};
         }},
        {"options",
         [](const Row& r) -> Cell {
             return {r.options, ""};
         }},
        {"timer",
         [](const Row& r) -> Cell {
             return {r.timer, ""};
         }},
        {"runs",
         [](const Row& r) -> Cell {
             return {r.runs, ""};
         }},
        {"ao_ms_min",
         [](const Row& r) -> Cell {
             return {r.accessibility.min_ms, ""};
         }},
        {"ao_ms_median",
         [](const Row& r) -> Cell {
             return {r.accessibility.median_ms, ""};
         }},
        {"ao_ms_p95",
         [](const Row& r) -> Cell {
             return {r.accessibility.p95_ms, ""};
         }},
        {"denoise_ms_min",
         [](const Row& r) -> Cell {
             return {r.filter.min_ms, ""};
         }},
        {"denoise_ms_median",
         [](const Row& r) -> Cell {
             return {r.filter.median_ms, ""};
         }},
        {"denoise_ms_p95",
         [](const Row& r) -> Cell {
             return {r.filter.p95_ms, ""};
         }},
        {"frame_ms_min",
         [](const Row& r) -> Cell {
             return {r.frame.min_ms, ""};
         }},
        {"frame_ms_median",
         [](const Row& r) -> Cell {
             return {r.frame.median_ms, ""};
         }},
        {"frame_ms_p95",
         [](const Row& r) -> Cell {
             return {r.frame.p95_ms, ""};
         }},
        {"second_layer_ms",
         [](const Row& r) -> Cell {
             return {r.layer_ms, ""};
         }},
        {"bytes",
         [](const Row& r) -> Cell {
             return {r.bytes, ""};
         }},
        {"pixels", [](const Row& r) { return possible(r.error, &Error::pixels); }},
        {"interior_rmse", [](const Row& r) { return possible(r.interior, &Error::rmse); }},
        {"interior_bias", [](const Row& r) { return possible(r.interior, &Error::bias); }},
        {"reference_radius_m",
         [](const Row& r) -> Cell {
             return {r.reference_radius_m, ""};
         }},
        {"reference_stderr",
         [](const Row& r) -> Cell {
             return {r.truth_stderr, ""};
         }},
        {"image_rmse", [](const Row& r) { return image(r, &FinalImageError::rmse); }},
        {"image_max", [](const Row& r) { return image(r, &FinalImageError::max); }},
        {"image_yee_failed", [](const Row& r) { return image(r, &FinalImageError::yee_failed); }},
    };
}

const std::vector<Column>& columns() {
    static const std::vector<Column> list = [] {
        std::vector<Column> all = fixed_columns();
        for (Column& column : further_columns()) all.push_back(std::move(column));
        return all;
    }();
    return list;
}

using Parameters = std::map<std::string, double>;

/// The parameters that tell the sets apart, the radius before others.
std::vector<std::string> telling_apart(const std::set<Parameters>& sets) {
    std::vector<std::string> order{"radius_m"};
    for (const auto& [name, value] : *sets.begin()) {
        if (name != order.front()) order.push_back(name);
    }
    std::vector<std::string> chosen;
    std::size_t told_apart = 1;
    for (const std::string& name : order) {
        chosen.push_back(name);
        std::set<std::vector<double>> seen;
        for (const Parameters& parameters : sets) {
            std::vector<double> values;
            for (const std::string& key : chosen) {
                const auto value = parameters.find(key);
                values.push_back(value != parameters.end() ? value->second : 0.0);
            }
            seen.insert(values);
        }
        if (seen.size() == told_apart) chosen.pop_back();
        told_apart = seen.size();
        if (told_apart == sets.size()) break;
    }
    return chosen;
}

std::string csv_cell(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return shortest(value.get<double>());
    return value.dump();
}

}  // namespace

std::string measurement_csv(const std::vector<MeasurementRow>& rows) {
    std::vector<std::string> cells;
    for (const Column& column : columns()) cells.emplace_back(column.name);
    std::string text = csv_line(cells);
    for (const MeasurementRow& row : rows) {
        cells.clear();
        for (const Column& column : columns()) cells.push_back(csv_cell(column.cell(row).value));
        text += csv_line(cells);
    }
    return text;
}

std::string measurement_json(const std::vector<MeasurementRow>& rows) {
    Json array = Json::array();
    for (const MeasurementRow& row : rows) {
        Json& object = array.emplace_back();
        for (const Column& column : columns()) {
            const Cell cell = column.cell(row);
            object[column.name] = cell.value;
            if (!cell.reason.empty()) object[std::string(column.name) + "_reason"] = cell.reason;
        }
        object["parameters"] = Json(row.parameters);
    }
    return array.dump(2) + '\n';
}

bool same_view(const MeasurementRow& a, const MeasurementRow& b) {
    const auto key = [](const Row& r) {
        return std::tie(r.scene_id, r.scene, r.camera, r.validity, r.width, r.height, r.device);
    };
    return key(a) == key(b);
}

std::string view_name(const MeasurementRow& row) {
    return row.scene_id + ", " + row.camera + ", " + row.validity;
}

void name_variants_apart(std::vector<MeasurementRow>& rows) {
    std::vector<std::string> names;
    for (const MeasurementRow& row : rows) {
        std::set<Parameters> sets;
        for (const MeasurementRow& other : rows) {
            if (same_view(row, other) && row.variant == other.variant &&
                row.fitted == other.fitted) {
                sets.insert(other.parameters);
            }
        }
        std::string name = row.variant;
        if (sets.size() > 1) {
            for (const std::string& key : telling_apart(sets)) {
                name += fmt::format(" {} {:.4g}", key == "radius_m" ? "R" : key,
                                    row.parameters.at(key));
            }
        }
        names.push_back(name);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].variant = names[i];
}

void mark_front(std::vector<MeasurementRow>& rows) {
    for (MeasurementRow& row : rows) {
        row.on_front = false;
        if (!row.error.has_value()) continue;
        std::vector<CostAndError> others;
        for (const MeasurementRow& other : rows) {
            if (other.error.has_value() && same_view(row, other)) {
                others.push_back({other.cost.median_ms, other.error->rmse});
            }
        }
        row.on_front = is_on_front({row.cost.median_ms, row.error->rmse}, others);
    }
}

}  // namespace obscura::analysis
