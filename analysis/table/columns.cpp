// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/table/columns.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "analysis/table/values.h"
#include "analysis/text/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr std::size_t kNamesShown = 30;

/// Insertions, deletions and exchanges of letters between them (Levenshtein 1966).
std::size_t distance(std::string_view one, std::string_view other) {
    std::vector<std::size_t> row(other.size() + 1);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = i;
    for (std::size_t i = 0; i < one.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < other.size(); ++j) {
            const std::size_t exchanged = diagonal + (one[i] == other[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, exchanged});
        }
    }
    return row.back();
}

/// How likely a file's column of that bare name is the known one: 0 not at all, 1 its own name.
double likeness(const std::string& theirs, const KnownColumn& known) {
    constexpr std::size_t kLongest = 60;
    if (theirs.empty() || theirs.size() > kLongest) return 0.0;
    for (std::size_t i = 0; i < known.hints.size(); ++i) {
        if (theirs == bare_name(known.hints[i])) return 0.95 - 0.002 * static_cast<double>(i);
    }
    double best = 0.0;
    const std::string ours = bare_name(known.name);
    constexpr double kLeast = 0.6;
    const double apart = static_cast<double>(distance(theirs, ours)) /
                         static_cast<double>(std::max(theirs.size(), ours.size()));
    if (1.0 - apart >= kLeast) best = 0.8 * (1.0 - apart);
    for (const std::string_view hint : known.hints) {
        const std::string bare = bare_name(hint);
        constexpr std::size_t kTelling = 4;  // shorter ones are parts of many names
        if (bare.size() >= kTelling && theirs.find(bare) != std::string::npos) {
            best = std::max(best, 0.5 + 0.3 * static_cast<double>(bare.size()) /
                                            static_cast<double>(theirs.size()));
        }
    }
    return best;
}

std::string list_of(const std::vector<std::string>& names) {
    const auto shown = std::min(names.size(), kNamesShown);
    std::string text = fmt::format(
        "{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
    if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
    return text;
}

}  // namespace

std::string bare_name(std::string_view name) {
    std::string bare;
    for (const char letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        if (code >= 0x80U || std::isalnum(code) != 0) {
            bare += static_cast<char>(code < 0x80U ? std::tolower(code) : code);
        }
    }
    return bare;
}

std::string map_option(std::string_view ours, std::string_view theirs) {
    const std::string word = fmt::format("{}={}", ours, theirs);
    const bool is_plain = std::all_of(word.begin(), word.end(), [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
               std::string_view("_-.=").find(letter) != std::string_view::npos;
    });
    return is_plain ? "--map " + word : "--map '" + word + "'";
}

ColumnMap::ColumnMap(const std::vector<std::string>& options) {
    for (const std::string& option : options) {
        const auto equals = option.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw base::bad_input("--map {}: allowed is OURS=THEIRS, as in observer=Subject",
                                  printable(option));
        }
        Entry entry{std::string(trimmed(option.substr(0, equals))),
                    std::string(trimmed(option.substr(equals + 1)))};
        if (find(entry.ours) != nullptr) {
            throw base::bad_input("--map {}: column {} is named twice", printable(option),
                                  printable(entry.ours));
        }
        entries_.push_back(std::move(entry));
    }
}

const ColumnMap::Entry* ColumnMap::find(std::string_view ours) const {
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& known) {
        return bare_name(known.ours) == bare_name(ours);
    });
    return entry == entries_.end() ? nullptr : &*entry;
}

Columns::Columns(const CsvRow& header, std::span<const KnownColumn> known, const ColumnMap& map,
                 FileProblems& problems)
    : known_(known), line_(header.line), place_(known.size()) {
    for (const std::string_view field : header.fields) names_.emplace_back(trimmed(field));
    place_mapped(map, problems);
    place_named(map, problems);
}

void Columns::place_mapped(const ColumnMap& map, FileProblems& problems) {
    for (const ColumnMap::Entry& entry : map.entries()) {
        const auto ours =
            std::find_if(known_.begin(), known_.end(), [&](const KnownColumn& column) {
                const auto is_it = [&](std::string_view name) {
                    return bare_name(name) == bare_name(entry.ours);
                };
                return is_it(column.name) ||
                       std::any_of(column.also.begin(), column.also.end(), is_it);
            });
        if (ours == known_.end()) {
            std::vector<std::string> names;
            for (const KnownColumn& column : known_) names.emplace_back(column.name);
            throw base::bad_input("--map {}={}: there is no column {}, allowed are {}",
                                  printable(entry.ours), printable(entry.theirs),
                                  printable(entry.ours), fmt::join(names, ", "));
        }
        if (entry.theirs.empty()) continue;
        const auto place = find(entry.theirs);
        if (!place) {
            problems.add(line_, fmt::format("--map {}={}: there is no column '{}'", entry.ours,
                                            printable(entry.theirs), printable(entry.theirs)));
            report_names(problems);
        }
        place_[static_cast<std::size_t>(ours - known_.begin())] = place;
    }
}

void Columns::place_named(const ColumnMap& map, FileProblems& problems) {
    for (std::size_t column = 0; column < known_.size(); ++column) {
        if (place_[column]) continue;
        std::vector<std::string_view> names{known_[column].name};
        names.insert(names.end(), known_[column].also.begin(), known_[column].also.end());
        const bool mapped = std::any_of(names.begin(), names.end(), [&](std::string_view name) {
            return map.find(name) != nullptr;
        });
        if (mapped) continue;
        // Just the name before one that differs in capitals or signs.
        for (const bool exact : {true, false}) {
            std::vector<std::size_t> met;
            for (std::size_t place = 0; place < names_.size(); ++place) {
                const bool is_it =
                    std::any_of(names.begin(), names.end(), [&](std::string_view name) {
                        return exact ? name == names_[place]
                                     : bare_name(name) == bare_name(names_[place]);
                    });
                if (is_it && !is_used(place)) met.push_back(place);
            }
            if (met.empty()) continue;
            place_[column] = met.front();
            if (met.size() > 1) {
                problems.add(line_, fmt::format("columns {} ('{}') and {} ('{}') are both {}, "
                                                "allowed is one",
                                                met[0] + 1, printable(names_[met[0]]), met[1] + 1,
                                                printable(names_[met[1]]), names.front()));
            }
            break;
        }
    }
}

std::optional<std::size_t> Columns::find(std::string_view name) const {
    for (std::size_t place = 0; place < names_.size(); ++place) {
        if (names_[place] == name) return place;
    }
    const std::string bare = bare_name(name);
    for (std::size_t place = 0; !bare.empty() && place < names_.size(); ++place) {
        if (bare_name(names_[place]) == bare) return place;
    }
    return std::nullopt;
}

bool Columns::is_used(std::size_t place) const {
    return std::find(place_.begin(), place_.end(), place) != place_.end();
}

std::string_view Columns::field(const CsvRow& row, std::size_t column) const {
    return place_[column] ? trimmed(row.fields[*place_[column]]) : std::string_view();
}

std::string_view Columns::name(std::size_t column) const {
    return place_[column] ? std::string_view(names_[*place_[column]]) : known_[column].name;
}

std::optional<std::string> Columns::advice(std::size_t column) const {
    constexpr std::size_t kLooked = 300;  // which a person could look through, too
    double best = 0.0;
    std::size_t likeliest = 0;
    for (std::size_t place = 0; place < std::min(names_.size(), kLooked); ++place) {
        if (is_used(place)) continue;
        const double own = likeness(bare_name(names_[place]), known_[column]);
        // What fits another column better is that one's.
        const bool is_others = std::any_of(known_.begin(), known_.end(), [&](const auto& other) {
            return &other != &known_[column] && likeness(bare_name(names_[place]), other) > own;
        });
        if (own > best && !is_others) {
            best = own;
            likeliest = place;
        }
    }
    if (best == 0.0) return std::nullopt;
    return map_option(known_[column].name, printable(names_[likeliest]));
}

void Columns::report_missing(std::size_t column, std::span<const std::size_t> instead,
                             FileProblems& problems) const {
    std::string text = fmt::format("column {} is missing", known_[column].name);
    for (const std::size_t other : instead) {
        text += fmt::format("{}{}", other == instead.front() ? ", allowed instead: " : ", ",
                            known_[other].name);
    }
    std::optional<std::string> option = advice(column);
    for (const std::size_t other : instead) {
        if (!option) option = advice(other);
    }
    text += option ? fmt::format("; perhaps {}", *option)
                   : fmt::format("; if the file calls it otherwise: --map {}=THEIRS",
                                 known_[column].name);
    problems.add(line_, text);
}

void Columns::report_names(FileProblems& problems) const {
    std::vector<std::string> names;
    for (const std::string& name : names_) {
        if (!name.empty()) names.push_back(printable(name));
    }
    problems.add(line_, fmt::format("the file's columns are {}", list_of(names)));
}

std::string Columns::passed_over(std::span<const std::string_view> ignored) const {
    std::vector<std::string> names;
    for (std::size_t place = 0; place < names_.size(); ++place) {
        const bool is_ignored =
            names_[place].empty() || is_used(place) ||
            std::find(ignored.begin(), ignored.end(), names_[place]) != ignored.end();
        if (!is_ignored) names.push_back(printable(names_[place]));
    }
    return names.empty() ? "" : list_of(names);
}

}  // namespace obscura::analysis
