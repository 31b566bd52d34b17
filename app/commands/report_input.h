// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/presentation/report.h"
#include "stimuli/study.h"

namespace obscura::app {

/// Where a report finds what the answers themselves do not hold.
struct ReportSources {
    std::filesystem::path data;           ///< the data folder: images, and a measurement
    std::optional<stimuli::Study> study;  ///< where its file is known
    std::filesystem::path measurement;    ///< empty: that of the data folder, where there is one
};

/// Adds the study's words, its images and the measurement to an input that has its analysis. What
/// is not there is named in it. Throws bad input for a manifest or measurement that is wrong, and
/// for a measurement asked for that is not there.
void add_sources(analysis::ReportInput& input, const ReportSources& sources);

/// The built-in study of that name, or nothing.
[[nodiscard]] std::optional<stimuli::Study> builtin_study(const std::string& name);

}  // namespace obscura::app
