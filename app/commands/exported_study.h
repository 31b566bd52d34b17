// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "analysis/export/export.h"
#include "stimuli/study.h"

namespace obscura::app {

/// What an export says of a study: the file's text and title, and the manifest of `images` where
/// one is there. Throws bad input for a manifest that cannot be read or is of another study.
[[nodiscard]] analysis::ExportedStudy exported_study(const stimuli::StudySource& source,
                                                     const stimuli::Study& study,
                                                     const std::filesystem::path& images);

/// The same without the study file, which is not at hand.
[[nodiscard]] analysis::ExportedStudy exported_study(const std::string& name,
                                                     const std::filesystem::path& images);

}  // namespace obscura::app
