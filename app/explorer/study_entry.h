// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "app/explorer/model.h"

namespace obscura::app::explorer {

/// What is to be written into a study file.
struct StudyEntry {
    std::filesystem::path file;
    std::string scene_id;
    std::string condition_id;  ///< empty: the scene alone
    bool replaces = false;     ///< the condition is there, and gets A and B in place of its sides
    std::optional<std::string> known_sha256;  ///< of the text that the person has seen
    bool takes_changed_file = false;          ///< whatever else the file holds is all right
};

/// What came of it.
struct StudyWritten {
    std::string text_sha256;
    std::vector<std::string> notes;  ///< what else the person should know, a sentence each
};

/// The view as a study's scene: a camera of the scene by its name, any other as it stands. Throws
/// bad input for a view that a study file cannot say.
[[nodiscard]] stimuli::StudyScene scene_of(const Model& model, const StudyEntry& entry);

/// The study's text with the view and, where a condition is named, with A and B. A scene of that id
/// that shows the same is used as it is. Throws bad input for everything that the study would be
/// refused for, each with its line, and where it would not show what is seen now.
[[nodiscard]] std::string study_with(const Model& model, const StudyEntry& entry,
                                     const std::string& text);

/// Writes it beside the file and renames; a file that is not there begins as a new study. Throws
/// bad input where the file cannot be written, or is not what the person has seen and
/// `takes_changed_file` is not set; nothing is changed then.
StudyWritten write_into_study(const Model& model, const StudyEntry& entry);

/// An id that no scene, or no condition, of the study has: `stem-1`.
[[nodiscard]] std::string free_scene_id(const std::optional<OpenStudy>& study, std::string stem);
[[nodiscard]] std::string free_condition_id(const std::optional<OpenStudy>& study);

}  // namespace obscura::app::explorer
