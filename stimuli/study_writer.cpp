// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/study_writer.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "stimuli/variant_format.h"

namespace obscura::stimuli {
namespace {

/// Where a line and column of the text are; both count from 1. Columns count code points.
std::size_t offset_of(std::string_view text, const toml::source_position& position) {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < position.line; ++line) {
        at = text.find('\n', at) + 1;
    }
    for (toml::source_index column = 1; column < position.column && at < text.size(); ++column) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
    }
    return at;
}

const toml::table* find_condition(const toml::table& study, const std::string& id) {
    const toml::array* conditions = study["condition"].as_array();
    if (conditions == nullptr) return nullptr;
    for (const toml::node& node : *conditions) {
        const toml::table* table = node.as_table();
        if (table != nullptr && (*table)["id"].value<std::string>() == id) return table;
    }
    return nullptr;
}

struct Replacement {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

}  // namespace

std::string with_variants(std::string_view text, const std::string& name,
                          const std::vector<VariantChange>& changes) {
    toml::table study;
    try {
        study = toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw base::bad_input("{}:{}: {}", name, error.source().begin.line, error.description());
    }
    std::vector<Replacement> replacements;
    for (const VariantChange& change : changes) {
        const toml::table* condition = find_condition(study, change.condition);
        const toml::table* side =
            condition == nullptr ? nullptr : (*condition)[std::string(1, change.side)].as_table();
        if (side == nullptr || !side->is_inline()) {
            throw base::bad_input("{}: condition \"{}\" has no side {} as an inline table", name,
                                  change.condition, change.side);
        }
        replacements.push_back({offset_of(text, side->source().begin),
                                offset_of(text, side->source().end), to_toml(change.choice)});
    }
    // From the end, so that what comes before keeps its place.
    std::sort(replacements.begin(), replacements.end(),
              [](const Replacement& a, const Replacement& b) { return a.begin > b.begin; });
    std::string changed(text);
    for (const Replacement& replacement : replacements) {
        changed.replace(replacement.begin, replacement.end - replacement.begin, replacement.text);
    }
    return changed;
}

}  // namespace obscura::stimuli
