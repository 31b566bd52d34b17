// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "stimuli/questions.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// A study file as far as it could be read, and everything wrong with it, ordered by line.
/// The study is of use only where there is no problem.
struct StudyReading {
    Study study;
    Questions questions;
    std::vector<StudyProblem> problems;
};

/// What stands against a study's name or an id, which become names of files; empty where nothing.
[[nodiscard]] std::string problem_of_id(const std::string& id);

/// Reads the text of a study file against the scenes that there are. Paths in it are relative to
/// `folder`; files of scenes are opened or not. Throws nothing of its own.
[[nodiscard]] StudyReading read_study(std::string_view text,
                                      const std::vector<BuiltinScene>& catalogue,
                                      const std::filesystem::path& folder = {},
                                      SceneFiles files = SceneFiles::kOpened);

}  // namespace obscura::stimuli
