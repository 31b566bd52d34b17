// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/study.h"

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

/// The text with a [[scene]] table behind everything else that SceneReader reads as that scene:
/// numbers are written so that they come back to the bit, where the file's words can say them.
/// Paths of `scene` are as they are to be written.
[[nodiscard]] std::string with_scene(std::string_view text, const StudyScene& scene);

/// The text with a [[condition]] table behind everything else; only id, scene and sides are
/// written.
[[nodiscard]] std::string with_condition(std::string_view text, const Condition& condition);

/// The text with both sides of a condition in place of those that it has. Throws bad input as
/// with_variants does, and where a side is no inline table.
[[nodiscard]] std::string with_sides(std::string_view text, const std::string& name,
                                     const std::string& condition, const renderer::Variant& a,
                                     const renderer::Variant& b);

/// A file's path as it is written in a study that lies in `folder`.
[[nodiscard]] std::string path_from(const std::filesystem::path& folder,
                                    const std::filesystem::path& file);

}  // namespace obscura::stimuli
