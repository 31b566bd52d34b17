// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/measurement_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "analysis/table/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

constexpr std::size_t kMostProblems = 20;

/// The columns of one file, and what is wrong in its cells.
class Reader {
  public:
    Reader(const CsvRecord& header, std::string name) : name_(std::move(name)) {
        for (std::size_t i = 0; i < header.fields.size(); ++i) {
            if (!place_.emplace(header.fields[i], i).second) {
                complain(header.line, header.fields[i], "", "each column once");
            }
        }
        for (const char* needed :
             {"scene", "camera", "validity", "technique", "samples", "ms_median", "rmse"}) {
            if (!place_.contains(needed)) complain(header.line, needed, "", "the column is needed");
        }
        columns_ = header.fields.size();
    }

    [[nodiscard]] bool begin(const CsvRecord& record) {
        record_ = &record;
        if (record.fields.size() == columns_) return true;
        complain(record.line, "all", fmt::format("{} cells", record.fields.size()),
                 fmt::format("{} cells, as many as the header has", columns_));
        return false;
    }

    [[nodiscard]] std::string text(const std::string& column) const {
        const auto place = place_.find(column);
        return place == place_.end() ? "" : record_->fields[place->second];
    }

    [[nodiscard]] Possible<double> number(const std::string& column, bool may_be_negative = false) {
        const std::string cell = text(column);
        if (cell.empty()) return Possible<double>::none("not measured");
        double value = 0.0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value) ||
            (value < 0.0 && !may_be_negative)) {
            complain(record_->line, column, cell,
                     may_be_negative ? "a finite number" : "a finite number of at least 0");
            return Possible<double>::none("not a number");
        }
        return value;
    }

    [[nodiscard]] int whole(const std::string& column) {
        constexpr double kMost = 1e6;
        const Possible<double> value = number(column);
        if (!value.has_value()) return 0;
        if (*value != std::floor(*value) || *value > kMost) {
            complain(record_->line, column, text(column), "a whole number, 0 to 1000000");
            return 0;
        }
        return static_cast<int>(*value);
    }

    [[nodiscard]] bool flag(const std::string& column) {
        const std::string cell = text(column);
        if (cell == "1" || cell == "true") return true;
        if (!cell.empty() && cell != "0" && cell != "false") {
            complain(record_->line, column, cell, "0, 1, false or true");
        }
        return false;
    }

    /// `radius_m=0.5;power=200`
    [[nodiscard]] std::map<std::string, double> numbers_by_name(const std::string& column) {
        std::map<std::string, double> numbers;
        const std::string cell = text(column);
        for (std::size_t begin = 0; begin < cell.size();) {
            const std::size_t end = std::min(cell.find(';', begin), cell.size());
            const std::string part = cell.substr(begin, end - begin);
            const std::size_t equals = std::min(part.find('='), part.size());
            const char* const last = part.data() + part.size();
            double value = 0.0;
            const auto [next, error] =
                std::from_chars(std::min(part.data() + equals + 1, last), last, value);
            if (equals == 0 || error != std::errc() || next != last || !std::isfinite(value)) {
                complain(record_->line, column, cell, "NAME=NUMBER, several with ; between them");
                break;
            }
            numbers[part.substr(0, equals)] = value;
            begin = end + 1;
        }
        return numbers;
    }

    void give_up_if_wrong() const {
        if (problems_.empty()) return;
        std::string message;
        for (const std::string& problem : problems_) {
            message += (message.empty() ? "" : "\n") + problem;
        }
        throw base::bad_input("{}", message);
    }

  private:
    void complain(int line, const std::string& column, const std::string& value,
                  const std::string& allowed) {
        if (problems_.size() >= kMostProblems) return;
        problems_.push_back(
            fmt::format("{}:{}: {} is \"{}\", allowed is {}", name_, line, column, value, allowed));
    }

    std::string name_;
    std::unordered_map<std::string, std::size_t> place_;
    std::size_t columns_ = 0;
    const CsvRecord* record_ = nullptr;
    std::vector<std::string> problems_;
};

MeasuredSetting row_of(Reader& reader) {
    MeasuredSetting row;
    row.scene_id = reader.text("scene_id");
    row.scene = reader.text("scene");
    row.camera = reader.text("camera");
    row.validity = reader.text("validity");
    row.technique = reader.text("technique");
    row.samples = reader.whole("samples");
    row.denoise = reader.text("blur");
    if (const std::string format = reader.text("depth_format"); !format.empty()) {
        row.depth_format = format;
    }
    if (const auto scale = reader.number("ao_scale"); scale.has_value()) row.ao_scale = *scale;
    row.width = reader.whole("width");
    row.height = reader.whole("height");
    row.device = reader.text("device");
    row.fitted = reader.flag("fitted");
    row.on_front = reader.flag("on_front");
    row.ms_median = reader.number("ms_median");
    row.rmse = reader.number("rmse");
    row.bias = reader.number("bias", true);
    row.parameters = reader.numbers_by_name("parameters");
    row.published = reader.text("published");
    return row;
}

}  // namespace

MeasurementTable read_measurement(const std::filesystem::path& file) {
    return parse_measurement(base::read_file(file), file.string());
}

MeasurementTable parse_measurement(std::string_view text, const std::string& name) {
    MeasurementTable table;
    table.source = name;
    std::optional<Reader> reader;
    for_each_csv_record(text, name, [&](CsvRecord&& record) {
        if (!reader) {
            reader.emplace(record, name);
            reader->give_up_if_wrong();
        } else if (reader->begin(record)) {
            table.rows.push_back(row_of(*reader));
        }
    });
    if (!reader) throw base::bad_input("{}:1: the file is empty, a header line is needed", name);
    reader->give_up_if_wrong();
    return table;
}

}  // namespace obscura::analysis
