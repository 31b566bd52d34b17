// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/measurement/report.h"
#include "app/measure/request.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::app {

/// What a measurement gave: the report, and the study with fitted values where it was asked for.
struct Measured {
    analysis::MeasurementReport report;
    /// Text of a study file for the request's `write_study`, parsed and checked; empty where none
    /// was asked for.
    std::string fitted_study;
    std::vector<std::string> notes;  ///< what of it is not as asked, a sentence each
    bool interrupted = false;        ///< by Ctrl-C: only the views that were finished are in it
};

/// Everything that the request asks for. Makes an OpenGL context of its own. Nothing is written
/// but truths into the request's cache. Throws bad input for what is wrong with the request, before
/// any work.
[[nodiscard]] Measured measure(
    const MeasureRequest& request,
    const std::vector<stimuli::BuiltinScene>& catalogue = stimuli::builtin_scenes());

/// A request with every number that was left out: the usual one, or that of `quick`.
[[nodiscard]] MeasureRequest with_defaults(MeasureRequest request);

}  // namespace obscura::app
