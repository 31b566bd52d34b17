// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/study.h"

namespace obscura::stimuli {

/// In double quotes, control characters escaped, long values cut: fit for one line of a message.
[[nodiscard]] std::string in_quotes(std::string_view value);

/// `a, b, c`, or `none`.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// The key of `names` that somebody who wrote `word` means: the base::nearest(), one that `word` is
/// a part of, or another word for it (fov for vertical_fov_deg, look_at for target_m); or nothing.
[[nodiscard]] std::optional<std::string> meant_key(std::string_view word,
                                                   const std::vector<std::string>& names);

/// `; did you mean "x"?` for the nearest name, or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& names);

/// Reads the keys of one table and notes everything that is wrong, each at its line. Every key
/// that is asked for counts as allowed; `finish` reports the others and the required ones that are
/// missing. A value that is wrong or missing comes back as nothing.
class TableReader {
  public:
    enum class Need { kRequired, kOptional };

    /// `where` begins each message: `study`, `scene "atrium-high"`.
    TableReader(const toml::table& table, std::string where, std::vector<StudyProblem>& problems);

    std::optional<std::string> text(const std::string& key, Need need);
    /// The text of `id`, which tables of answers take as a name: 1 to 40 of a-z 0-9 _. What it
    /// names is said where it is another.
    std::string safe_id(const std::string& of_what);
    std::optional<bool> boolean(const std::string& key, Need need);
    std::optional<std::int64_t> integer(const std::string& key, Need need, std::int64_t low,
                                        std::int64_t high);
    std::optional<double> number(const std::string& key, Need need);
    /// A number within [low, high]; NaN is not.
    std::optional<double> number(const std::string& key, Need need, double low, double high);
    /// An array of `count` numbers within [low, high]; empty where it is missing or wrong.
    std::vector<double> numbers(const std::string& key, Need need, std::size_t count, double low,
                                double high);
    /// A text out of a list of names.
    std::optional<std::string> choice(const std::string& key, Need need,
                                      const std::vector<std::string>& names);
    const toml::array* array(const std::string& key, Need need, std::string_view wanted);
    const toml::table* table(const std::string& key, Need need);

    [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }

    /// Whether `key` is not there, but one that nobody asked for is and means it: what follows from
    /// its absence is not worth saying.
    [[nodiscard]] bool is_misspelt(const std::string& key) const;

    /// Lets `key` be there without reading it.
    void allow(const std::string& key);
    /// A key that is not allowed here and has its place elsewhere: `has radius_m` ... `blizzard`.
    void known_elsewhere(const std::string& key, const std::string& owner);

    /// Notes a problem with the value of `key`, at the key's line.
    void add(const std::string& key, const std::string& message);

    /// Reports unknown keys with the nearest allowed one, and required keys that are missing.
    /// A required key whose misspelling was just reported is not reported again.
    void finish();

    /// The table that is read.
    [[nodiscard]] const toml::table& table() const { return table_; }

  private:
    const toml::node* find(const std::string& key, Need need);
    void wrong_type(const std::string& key, const toml::node& value, std::string_view wanted);

    const toml::table& table_;
    std::string where_;
    std::vector<StudyProblem>& problems_;
    std::vector<std::string> allowed_;
    std::vector<std::string> missing_;
    std::map<std::string, std::vector<std::string>> elsewhere_;  ///< owners by key
};

/// The names of a list of values, by their to_string.
template <typename List>
[[nodiscard]] std::vector<std::string> names_of(const List& list) {
    std::vector<std::string> names;
    for (const auto& value : list) names.emplace_back(to_string(value));
    return names;
}

/// The line on which a value or a table begins, from 1; 0: not known.
[[nodiscard]] int line_of(const toml::node& node);

}  // namespace obscura::stimuli
