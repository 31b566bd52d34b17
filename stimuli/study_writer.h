// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::stimuli {

/// Parameters of one side of a condition as they are to become.
struct VariantChange {
    std::string condition;
    char side = 'a';  ///< a or b
    std::map<std::string, double> parameters;
};

/// The text of a study file with those parameters replaced where the side has them and added where
/// it has not; everything else, comments too, stays as it is. Numbers are written in full. Throws
/// bad input naming `name` for a text that is no TOML, that has not such a condition, or for two
/// changes of one side.
[[nodiscard]] std::string with_variants(std::string_view text, const std::string& name,
                                        const std::vector<VariantChange>& changes);

/// The text of a study file that lies in `from` as it has to be in `to`: the files of its scenes
/// and their environments, which are named relative to the study's folder, are named so that they
/// are found from there. Absolute paths and built-in scenes stay. Throws bad input as with_variants
/// does.
[[nodiscard]] std::string with_paths_from(std::string_view text, const std::string& name,
                                          const std::filesystem::path& from,
                                          const std::filesystem::path& to);

}  // namespace obscura::stimuli
