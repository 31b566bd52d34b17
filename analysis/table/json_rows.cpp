// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/table/json_rows.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <utility>

#include "analysis/text/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLargestArray = 8;
constexpr int kDeepestMember = 3;
constexpr int kDeepest = 64;  // beyond what data of a trial has
constexpr std::size_t kMostColumns = 10'000;

struct Row {
    int line = 0;
    std::vector<std::pair<std::size_t, std::string>> fields;  ///< place of the column, value
};

/// Finds the outermost objects and what parts them.
class Scanner {
  public:
    Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    /// The text of the next object, with the line where it begins; nothing at the end.
    [[nodiscard]] std::string_view next(int& line) {
        for (; at_ < text_.size(); ++at_) {
            const char letter = text_[at_];
            if (letter == '{') {
                line = line_;
                return object();
            }
            step(letter);
        }
        if (!closing_.empty()) throw problem(line_, "the text ends within an array");
        return {};
    }

    [[nodiscard]] base::Error problem(int line, std::string_view what) const {
        return base::bad_input("{}:{}: {}", name_, line, what);
    }

  private:
    /// Between objects: only what parts them.
    void step(char letter) {
        if (letter == '\n') ++line_;
        if (letter == '[') {
            closing_.push_back(']');
            if (closing_.size() > kDeepest) throw problem(line_, "arrays within arrays, too deep");
        } else if (letter == ']' && !closing_.empty()) {
            closing_.pop_back();
        } else if (letter != ',' && letter != ' ' && letter != '\n' && letter != '\r' &&
                   letter != '\t') {
            throw problem(line_, fmt::format("'{}' stands where JSON has an object for each row, "
                                             "allowed are an array of objects, or objects",
                                             printable(text_.substr(at_), 20)));
        }
    }

    std::string_view object() {
        const std::size_t begin = at_;
        const int line = line_;
        int depth = 0;
        bool in_string = false;
        for (; at_ < text_.size(); ++at_) {
            const char letter = text_[at_];
            if (letter == '\n') ++line_;
            if (in_string) {
                if (letter == '\\') ++at_;
                if (letter == '"') in_string = false;
            } else if (letter == '"') {
                in_string = true;
            } else if (letter == '{' || letter == '[') {
                if (++depth > kDeepest) throw problem(line_, "objects within objects, too deep");
            } else if (letter == '}' || letter == ']') {
                if (--depth == 0) {
                    ++at_;
                    return text_.substr(begin, at_ - begin);
                }
            }
        }
        throw problem(line, "the object that begins here is never closed");
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::string closing_;
};

std::string text_of(const ordered_json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return shortest(value.get<double>());
    return value.dump();
}

class JsonColumns {
  public:
    void add(const std::string& name, const ordered_json& value, int depth, Row& row) {
        const bool is_short =
            value.is_object() || (value.is_array() && value.size() <= kLargestArray);
        const bool opens = depth < kDeepestMember && !value.empty() && is_short;
        if (depth > 0 && !opens) {
            row.fields.emplace_back(place_of(name), text_of(value));
        } else if (value.is_object()) {
            for (const auto& [member, inner] : value.items()) {
                add(name.empty() ? member : name + '.' + member, inner, depth + 1, row);
            }
        } else {
            for (std::size_t i = 0; i < value.size(); ++i) {
                add(fmt::format("{}[{}]", name, i), value[i], depth + 1, row);
            }
        }
    }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  private:
    std::size_t place_of(const std::string& name) {
        const auto [place, is_new] = places_.emplace(name, names_.size());
        if (is_new) names_.push_back(name);
        return place->second;
    }

    std::vector<std::string> names_;
    std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace

void for_each_json_row(std::string_view text, const std::string& name,
                       const std::function<void(const CsvRow&)>& take) {
    Scanner scanner(text, name);
    JsonColumns columns;
    std::vector<Row> rows;
    int line = 1;
    for (auto object = scanner.next(line); !object.empty(); object = scanner.next(line)) {
        Row row{line, {}};
        try {
            columns.add("", ordered_json::parse(object), 0, row);
        } catch (const nlohmann::json::exception&) {
            throw scanner.problem(line,
                                  fmt::format("'{}' is no JSON object", printable(object, 40)));
        }
        if (columns.names().size() > kMostColumns) {
            throw scanner.problem(line, fmt::format("the objects up to here have more than {} "
                                                    "different members",
                                                    kMostColumns));
        }
        rows.push_back(std::move(row));
    }
    if (rows.empty()) return;
    std::vector<std::string_view> fields(columns.names().begin(), columns.names().end());
    take({rows.front().line, fields});
    for (const Row& row : rows) {
        std::fill(fields.begin(), fields.end(), std::string_view());
        for (const auto& [place, value] : row.fields) fields[place] = value;
        take({row.line, fields});
    }
}

}  // namespace obscura::analysis
