// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/json_cursor.h"

#include <cmath>

#include "renderer/base/error.h"

namespace obscura::renderer::import_detail {

std::string one_line(std::string_view text) {
    constexpr std::size_t kLongest = 64;
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        // Cut only where a character begins: bytes 10xxxxxx continue one in UTF-8.
        if (line.size() >= kLongest && (byte & 0xC0U) != 0x80U) return line + "...";
        line += byte < 0x20U || byte == 0x7FU ? '?' : c;
    }
    return line;
}

void JsonCursor::fail(const std::string& message) const {
    throw base::bad_input("{}: {}: {}", *file_, place_.empty() ? "the document" : place_, message);
}

std::string JsonCursor::met() const {
    if (value_->is_object()) return "an object";
    if (value_->is_array()) return fmt::format("an array of {}", value_->size());
    if (value_->is_string()) return '"' + one_line(value_->get_ref<const std::string&>()) + '"';
    return value_->dump();
}

std::optional<JsonCursor> JsonCursor::find(const char* key) const {
    if (!value_->is_object()) fail(fmt::format("is {}, allowed is an object", met()));
    const auto found = value_->find(key);
    if (found == value_->end()) return std::nullopt;
    return JsonCursor(*found, place_.empty() ? key : place_ + '.' + key, *file_);
}

JsonCursor JsonCursor::at(const char* key) const {
    auto member = find(key);
    if (!member) fail(fmt::format("{} is missing", key));
    return *member;
}

std::size_t JsonCursor::count() const {
    if (!value_->is_array()) fail(fmt::format("is {}, allowed is an array", met()));
    return value_->size();
}

std::size_t JsonCursor::count(const char* key) const {
    const auto member = find(key);
    return member ? member->count() : 0;
}

JsonCursor JsonCursor::item(std::size_t i) const {
    return {(*value_)[i], fmt::format("{}[{}]", place_, i), *file_};
}

std::int64_t JsonCursor::integer(std::int64_t low, std::int64_t high) const {
    // Some writers give whole numbers a fraction of zero.
    const bool whole =
        value_->is_number_integer() ||
        (value_->is_number_float() && value_->get<double>() == std::floor(value_->get<double>()) &&
         std::abs(value_->get<double>()) < 1e15);
    if (whole) {
        const bool huge =
            value_->is_number_unsigned() && value_->get<std::uint64_t>() > std::uint64_t{INT64_MAX};
        const auto value = value_->get<std::int64_t>();
        if (!huge && value >= low && value <= high) return value;
    }
    fail(fmt::format("is {}, allowed is a whole number from {} to {}", met(), low, high));
}

std::int64_t JsonCursor::integer(const char* key, std::int64_t otherwise, std::int64_t low,
                                 std::int64_t high) const {
    const auto member = find(key);
    return member ? member->integer(low, high) : otherwise;
}

double JsonCursor::number(double low, double high) const {
    if (value_->is_number()) {
        const auto value = value_->get<double>();
        if (value >= low && value <= high) return value;
    }
    fail(fmt::format("is {}, allowed is a number from {} to {}", met(), low, high));
}

double JsonCursor::number(const char* key, double otherwise, double low, double high) const {
    const auto member = find(key);
    return member ? member->number(low, high) : otherwise;
}

std::vector<double> JsonCursor::numbers(const char* key,
                                        const std::vector<double>& otherwise) const {
    const auto member = find(key);
    if (!member) return otherwise;
    if (!member->json().is_array() || member->json().size() != otherwise.size()) {
        member->fail(fmt::format("is {}, allowed is an array of {} numbers", member->met(),
                                 otherwise.size()));
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < otherwise.size(); ++i) values.push_back(member->item(i).number());
    return values;
}

bool JsonCursor::truth(const char* key, bool otherwise) const {
    const auto member = find(key);
    if (!member) return otherwise;
    if (!member->json().is_boolean()) {
        member->fail(fmt::format("is {}, allowed are true and false", member->met()));
    }
    return member->json().get<bool>();
}

std::string JsonCursor::text(const char* key, const std::string& otherwise) const {
    const auto member = find(key);
    if (!member) return otherwise;
    if (!member->json().is_string()) {
        member->fail(fmt::format("is {}, allowed is a text", member->met()));
    }
    return member->json().get<std::string>();
}

std::string JsonCursor::name(const std::string& otherwise) const {
    const std::string given = one_line(text("name", ""));
    return given.empty() ? otherwise : given;
}

std::optional<std::size_t> JsonCursor::index(const char* key, std::size_t count,
                                             const char* what) const {
    const auto member = find(key);
    if (!member) return std::nullopt;
    return member->index(count, what);
}

std::size_t JsonCursor::index(std::size_t count, const char* what) const {
    if (value_->is_number_integer()) {
        if (value_->is_number_unsigned() && value_->get<std::uint64_t>() < count) {
            return value_->get<std::size_t>();
        }
    } else if (value_->is_number_float()) {
        const auto value = value_->get<double>();
        if (value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value)) {
            return static_cast<std::size_t>(value);
        }
    }
    fail(count == 0 ? fmt::format("is {}, but the file has no {}", met(), what)
                    : fmt::format("is {}, allowed is 0 to {}: the file has {} {}", met(), count - 1,
                                  count, what));
}

}  // namespace obscura::renderer::import_detail
