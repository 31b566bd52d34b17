// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "renderer/base/nearest.h"

namespace obscura::stimuli {
namespace {

std::string_view type_in_words(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "an integer";
        case toml::node_type::floating_point:
            return "a number with a fraction";
        case toml::node_type::boolean:
            return "a truth value";
        default:
            return "a date or time";
    }
}

/// What people write for a key, and the key; the first whose key is allowed is meant.
constexpr std::array<std::pair<std::string_view, std::string_view>, 35> kOtherWords{{
    {"look_at", "target_m"},
    {"lookat", "target_m"},
    {"at", "target_m"},
    {"eye", "position_m"},
    {"from", "position_m"},
    {"location", "position_m"},
    {"fov", "vertical_fov_deg"},
    {"fovy", "vertical_fov_deg"},
    {"field_of_view", "vertical_fov_deg"},
    {"size", "resolution"},
    {"width", "resolution"},
    {"dimensions", "resolution"},
    {"method", "technique"},
    {"algorithm", "technique"},
    {"ao", "technique"},
    {"type", "technique"},
    {"blur", "denoise"},
    {"filter", "denoise"},
    {"smooth", "denoise"},
    {"file", "source"},
    {"path", "source"},
    {"model", "source"},
    {"mesh", "source"},
    {"lighting", "validity"},
    {"level", "validity"},
    {"hdri", "environment"},
    {"envmap", "environment"},
    {"unit", "scale"},
    {"units", "scale"},
    {"expected", "catch"},
    {"expects", "catch"},
    {"attention_check", "catch"},
    {"left", "a"},
    {"right", "b"},
    {"exclude", "exclusion"},
}};

constexpr std::size_t kLongestShown = 60;  // bytes of a value that a message repeats

}  // namespace

std::string in_quotes(std::string_view value) {
    std::string shown = "\"";
    for (std::size_t i = 0; i < value.size(); ++i) {
        const auto byte = static_cast<unsigned char>(value[i]);
        // Cut only where a character begins: bytes 10xxxxxx continue one in UTF-8.
        if (i >= kLongestShown && (byte & 0xC0U) != 0x80U) return shown + "...\"";
        if (byte < 0x20U || byte == 0x7FU) {
            shown += fmt::format("\\x{:02x}", byte);
        } else {
            shown += value[i];
        }
    }
    return shown + "\"";
}

std::string listed(const std::vector<std::string>& names) {
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::optional<std::string> meant_key(std::string_view word, const std::vector<std::string>& names) {
    const auto is_one = [&](std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const auto& [other, key] : kOtherWords) {
        if (word == other && is_one(key)) return std::string(key);
    }
    if (auto best = base::nearest(word, names)) return best;
    constexpr std::size_t kShortestPart = 3;
    if (word.size() < kShortestPart) return std::nullopt;
    for (const std::string& name : names) {  // fov_deg for vertical_fov_deg, samples_a for samples
        const bool is_part =
            fmt::format("_{}_", name).find(fmt::format("_{}_", word)) != std::string::npos;
        const bool has_part =
            name.size() >= kShortestPart &&
            fmt::format("_{}_", word).find(fmt::format("_{}_", name)) != std::string::npos;
        if (is_part || has_part) return name;
    }
    return std::nullopt;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
    const std::optional<std::string> guess = base::nearest(word, names);
    return guess ? fmt::format("; did you mean \"{}\"?", *guess) : "";
}

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

TableReader::TableReader(const toml::table& table, std::string where,
                         std::vector<StudyProblem>& problems)
    : table_(table), where_(std::move(where)), problems_(problems) {}

void TableReader::add(const std::string& key, const std::string& message) {
    const auto found = table_.find(key);
    const int line = found != table_.end() ? static_cast<int>(found->first.source().begin.line)
                                           : line_of(table_);
    const std::string mistake = fmt::format("{}: {}", key, message);
    problems_.push_back({line, fmt::format("{}: {}", where_, mistake), where_, mistake});
}

void TableReader::wrong_type(const std::string& key, const toml::node& value,
                             std::string_view wanted) {
    add(key, fmt::format("is {}, allowed is {}", type_in_words(value), wanted));
}

bool TableReader::is_misspelt(const std::string& key) const {
    if (has(key)) return false;
    return std::any_of(table_.begin(), table_.end(), [&](const auto& entry) {
        const std::string name{entry.first.str()};
        const bool is_allowed = std::find(allowed_.begin(), allowed_.end(), name) != allowed_.end();
        return !is_allowed && meant_key(name, {key}).has_value();
    });
}

void TableReader::known_elsewhere(const std::string& key, const std::string& owner) {
    elsewhere_[key].push_back(owner);
}

void TableReader::allow(const std::string& key) {
    if (std::find(allowed_.begin(), allowed_.end(), key) == allowed_.end()) {
        allowed_.push_back(key);
    }
}

const toml::node* TableReader::find(const std::string& key, Need need) {
    allow(key);
    const toml::node* value = table_.get(key);
    if (value == nullptr && need == Need::kRequired) missing_.push_back(key);
    return value;
}

std::optional<bool> TableReader::boolean(const std::string& key, Need need) {
    const toml::node* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (!value->is_boolean()) {
        wrong_type(key, *value, "true or false");
        return std::nullopt;
    }
    return **value->as_boolean();
}

std::string TableReader::safe_id(const std::string& of_what) {
    constexpr std::size_t kLongest = 40;
    const std::string id = text("id", Need::kRequired).value_or("");
    const bool safe =
        !id.empty() && id.size() <= kLongest && std::all_of(id.begin(), id.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        });
    if (!safe && has("id")) {
        add("id", fmt::format("{} is no name of a {}, allowed are 1 to {} of a-z 0-9 _",
                              in_quotes(id), of_what, kLongest));
    }
    return id;
}

std::optional<std::string> TableReader::text(const std::string& key, Need need) {
    const toml::node* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (!value->is_string()) {
        wrong_type(key, *value, "a string");
        return std::nullopt;
    }
    std::string text = **value->as_string();
    for (std::size_t at = text.find("\r\n"); at != std::string::npos; at = text.find("\r\n", at)) {
        text.erase(at, 1);  // a file saved with the line ends of Windows means the same
    }
    const auto forbidden = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\t') || c == 0x7F;
    };
    if (std::any_of(text.begin(), text.end(), forbidden)) {
        add(key, fmt::format("{} holds a control character, allowed are text, line breaks and tabs",
                             in_quotes(text)));
        return std::nullopt;
    }
    return text;
}

std::optional<std::int64_t> TableReader::integer(const std::string& key, Need need,
                                                 std::int64_t low, std::int64_t high) {
    const toml::node* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (!value->is_integer()) {
        wrong_type(key, *value, fmt::format("an integer from {} to {}", low, high));
        return std::nullopt;
    }
    const std::int64_t number = **value->as_integer();
    if (number < low || number > high) {
        add(key, fmt::format("{} is out of range, allowed is {} to {}", number, low, high));
        return std::nullopt;
    }
    return number;
}

std::optional<double> TableReader::number(const std::string& key, Need need) {
    const toml::node* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (!value->is_number()) {
        wrong_type(key, *value, "a number");
        return std::nullopt;
    }
    // By hand, because toml++ gives nothing for an integer that a double only comes near to.
    if (value->is_integer()) return static_cast<double>(**value->as_integer());
    return **value->as_floating_point();
}

std::optional<double> TableReader::number(const std::string& key, Need need, double low,
                                          double high) {
    const std::optional<double> value = number(key, need);
    if (value && !(*value >= low && *value <= high)) {
        add(key, fmt::format("{} is out of range, allowed is {} to {}", *value, low, high));
        return std::nullopt;
    }
    return value;
}

std::vector<double> TableReader::numbers(const std::string& key, Need need, std::size_t count,
                                         double low, double high) {
    const std::string wanted =
        fmt::format("an array of {} numbers from {} to {}", count, low, high);
    const toml::array* list = array(key, need, wanted);
    if (list == nullptr) return {};
    std::vector<double> values;
    for (const toml::node& node : *list) {
        const std::optional<double> value = node.value<double>();
        if (value && *value >= low && *value <= high) values.push_back(*value);
    }
    if (values.size() != list->size() || values.size() != count) {
        add(key, fmt::format("allowed is {}", wanted));
        return {};
    }
    return values;
}

std::optional<std::string> TableReader::choice(const std::string& key, Need need,
                                               const std::vector<std::string>& names) {
    std::optional<std::string> chosen = text(key, need);
    if (chosen && std::find(names.begin(), names.end(), *chosen) == names.end()) {
        add(key, fmt::format("{} is unknown, allowed are {}{}", in_quotes(*chosen), listed(names),
                             did_you_mean(*chosen, names)));
        return std::nullopt;
    }
    return chosen;
}

const toml::array* TableReader::array(const std::string& key, Need need, std::string_view wanted) {
    const toml::node* value = find(key, need);
    if (value == nullptr) return nullptr;
    if (!value->is_array()) wrong_type(key, *value, wanted);
    return value->as_array();
}

const toml::table* TableReader::table(const std::string& key, Need need) {
    const toml::node* value = find(key, need);
    if (value == nullptr) return nullptr;
    if (!value->is_table()) wrong_type(key, *value, "a table");
    return value->as_table();
}

void TableReader::finish() {
    std::vector<std::string> others;
    for (const auto& [key, owners] : elsewhere_) others.push_back(key);
    for (const auto& [key, value] : table_) {
        const std::string name{key.str()};
        if (std::find(allowed_.begin(), allowed_.end(), name) != allowed_.end()) continue;
        std::string guess;
        if (const auto meant = meant_key(name, allowed_)) {
            guess = fmt::format("; did you mean \"{}\"?", *meant);
            std::erase(missing_, *meant);
        } else if (const auto other = meant_key(name, others)) {
            guess =
                fmt::format("; \"{}\" is a setting of {}", *other, listed(elsewhere_.at(*other)));
        }
        // Where the key that is meant is known, what else is allowed there makes no other mistake.
        problems_.push_back({static_cast<int>(key.source().begin.line),
                             fmt::format("{}: {} is an unknown key, allowed are {}{}", where_,
                                         in_quotes(name), listed(allowed_), guess),
                             where_, name + (guess.empty() ? listed(allowed_) : guess)});
    }
    for (const std::string& key : missing_) {
        problems_.push_back({line_of(table_), fmt::format("{}: {} is missing", where_, key)});
    }
}

}  // namespace obscura::stimuli
