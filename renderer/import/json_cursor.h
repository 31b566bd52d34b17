// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::renderer::import_detail {

/// A place in a JSON document that knows where it is: every wrong type or value is thrown as bad
/// input naming file, place (`meshes[3].primitives[0].mode`), what was met and what is allowed.
/// The document and the file's name must outlive it.
class JsonCursor {
  public:
    JsonCursor(const nlohmann::json& value, std::string place, const std::string& file)
        : value_(&value), place_(std::move(place)), file_(&file) {}

    [[nodiscard]] const std::string& place() const { return place_; }
    [[nodiscard]] const nlohmann::json& json() const { return *value_; }

    /// The member of that name, or nothing; this must be an object.
    [[nodiscard]] std::optional<JsonCursor> find(const char* key) const;
    /// The member of that name, which must be there.
    [[nodiscard]] JsonCursor at(const char* key) const;
    /// The element of an array; `i` must be below count().
    [[nodiscard]] JsonCursor item(std::size_t i) const;
    /// Elements of this array.
    [[nodiscard]] std::size_t count() const;
    /// Elements of the array of that name; 0 where it is not there.
    [[nodiscard]] std::size_t count(const char* key) const;

    [[nodiscard]] std::int64_t integer(std::int64_t low, std::int64_t high) const;
    [[nodiscard]] std::int64_t integer(const char* key, std::int64_t otherwise, std::int64_t low,
                                       std::int64_t high) const;
    /// A number within [low, high].
    [[nodiscard]] double number(double low = -1e30, double high = 1e30) const;
    [[nodiscard]] double number(const char* key, double otherwise, double low = -1e30,
                                double high = 1e30) const;
    /// An array of exactly `otherwise.size()` numbers.
    [[nodiscard]] std::vector<double> numbers(const char* key,
                                              const std::vector<double>& otherwise) const;
    [[nodiscard]] bool truth(const char* key, bool otherwise) const;
    /// Any text; names are made fit for one line with `name`.
    [[nodiscard]] std::string text(const char* key, const std::string& otherwise) const;
    /// The member `name` without control characters and cut to 64 bytes, else `otherwise`.
    [[nodiscard]] std::string name(const std::string& otherwise) const;
    /// An index into `count` things called `what`, nothing where the key is not there.
    [[nodiscard]] std::optional<std::size_t> index(const char* key, std::size_t count,
                                                   const char* what) const;
    /// This value as an index into `count` things called `what`.
    [[nodiscard]] std::size_t index(std::size_t count, const char* what) const;

    /// Throws bad input: `FILE: PLACE: message`.
    [[noreturn]] void fail(const std::string& message) const;

  private:
    /// What was met, short.
    [[nodiscard]] std::string met() const;

    const nlohmann::json* value_;
    std::string place_;
    const std::string* file_;
};

/// Fit for one line: no control characters, at most 64 bytes.
[[nodiscard]] std::string one_line(std::string_view text);

}  // namespace obscura::renderer::import_detail
