// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/study_writer.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <set>
#include <utility>

#include "renderer/base/error.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/study_text.h"
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

toml::table parsed(std::string_view text, const std::string& name) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw base::bad_input("{}:{}: {}", name, error.source().begin.line, error.description());
    }
}

std::string replaced(std::string_view text, std::vector<Replacement> replacements) {
    // From the end, so that what comes before keeps its place.
    std::stable_sort(replacements.begin(), replacements.end(),
                     [](const Replacement& a, const Replacement& b) { return a.begin > b.begin; });
    std::string changed(text);
    for (const Replacement& replacement : replacements) {
        changed.replace(replacement.begin, replacement.end - replacement.begin, replacement.text);
    }
    return changed;
}

Replacement in_place_of(std::string_view text, const toml::node& node, std::string by) {
    return {offset_of(text, node.source().begin), offset_of(text, node.source().end),
            std::move(by)};
}

/// The parameters that a side has are replaced, the others added behind its last value.
void change_side(std::string_view text, const toml::table& side, const VariantChange& change,
                 std::vector<Replacement>& replacements) {
    std::size_t last = 0;
    for (const auto& [key, value] : side) {
        last = std::max(last, offset_of(text, value.source().end));
    }
    Replacement added{last, last, ""};
    for (const auto& [key, value] : change.parameters) {
        const toml::node* node = side.get(key);
        if (node != nullptr) {
            replacements.push_back(in_place_of(text, *node, toml_float(value)));
        } else {
            added.text +=
                fmt::format("{}{} = {}", side.is_inline() ? ", " : "\n", key, toml_float(value));
        }
    }
    if (!added.text.empty()) replacements.push_back(added);
}

}  // namespace

std::string quoted(const std::string& text) {
    std::string safe = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') safe += '\\';
        if (static_cast<unsigned char>(letter) < 0x20U) {
            safe += fmt::format("\\u{:04x}", static_cast<int>(letter));
        } else {
            safe += letter;
        }
    }
    return safe + '"';
}

std::string with_variants(std::string_view text, const std::string& name,
                          const std::vector<VariantChange>& changes) {
    const toml::table study = parsed(text, name);
    std::vector<Replacement> replacements;
    std::set<std::pair<std::string, char>> changed;
    for (const VariantChange& change : changes) {
        const toml::table* condition = find_condition(study, change.condition);
        const toml::table* side =
            condition == nullptr ? nullptr : (*condition)[std::string(1, change.side)].as_table();
        if (side == nullptr) {
            throw base::bad_input("{}: condition \"{}\" has no side {} of its own", name,
                                  change.condition, change.side);
        }
        if (!changed.insert({change.condition, change.side}).second) {
            throw base::bad_input("{}: side {} of condition \"{}\" is to be changed twice", name,
                                  change.side, change.condition);
        }
        change_side(text, *side, change, replacements);
    }
    return replaced(text, std::move(replacements));
}

std::string with_sides(std::string_view text, const std::string& name, const std::string& condition,
                       const renderer::Variant& a, const renderer::Variant& b) {
    const toml::table study = parsed(text, name);
    const toml::table* table = find_condition(study, condition);
    std::vector<Replacement> replacements;
    for (const auto& [side, variant] : {std::pair{"a", &a}, {"b", &b}}) {
        const toml::table* now = table == nullptr ? nullptr : (*table)[side].as_table();
        if (now == nullptr || !now->is_inline()) {
            throw base::bad_input(
                "{}: condition \"{}\" has no side {} that can be replaced, allowed is an inline "
                "table: {} = {{ technique = ... }}",
                name, condition, side, side);
        }
        replacements.push_back(in_place_of(text, *now, to_toml(*variant)));
    }
    return replaced(text, std::move(replacements));
}

std::string with_paths_from(std::string_view text, const std::string& name,
                            const std::filesystem::path& from, const std::filesystem::path& to) {
    const toml::table study = parsed(text, name);
    std::vector<Replacement> replacements;
    const toml::array* scenes = study["scene"].as_array();
    if (scenes == nullptr) return std::string(text);
    for (const toml::node& scene : *scenes) {
        if (!scene.is_table()) continue;
        for (const char* key : {"source", "environment"}) {
            const toml::node* node = scene.as_table()->get(key);
            const auto path = node != nullptr ? node->value<std::string>() : std::nullopt;
            if (!path || std::filesystem::path(*path).is_absolute()) continue;
            if (key == std::string_view("source") && !is_file_source(*path)) continue;
            const std::string moved = path_from(to, from / *path);
            if (moved != path_from(from, from / *path)) {
                replacements.push_back(in_place_of(text, *node, quoted(moved)));
            }
        }
    }
    return replaced(text, std::move(replacements));
}

std::string path_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
    namespace fs = std::filesystem;
    const auto whole = [](const fs::path& path) {
        return fs::weakly_canonical(fs::absolute(path.empty() ? "." : path));
    };
    const fs::path target = whole(file);
    const fs::path relative = target.lexically_relative(whole(folder));
    return (relative.empty() ? target : relative).generic_string();
}

}  // namespace obscura::stimuli
