// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/selection.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// Renders the selected images in memory and tells of each its passes with milliseconds (of the
/// last of four renderings, after three that are discarded), the range of those four, its buffers
/// with bytes, how many texels the technique reads, and what was left out. Ends with a table of
/// milliseconds and bytes as planned and with nothing left out.
[[nodiscard]] std::string explain(const Study& study, const Selection& selection, bool quiet,
                                  const std::vector<BuiltinScene>& catalogue = builtin_scenes());

/// The same as a JSON array, an object an image: passes with milliseconds, buffers with bytes, what
/// was left out, and the sums as planned and with nothing left out.
[[nodiscard]] std::string explain_json(
    const Study& study, const Selection& selection, bool quiet,
    const std::vector<BuiltinScene>& catalogue = builtin_scenes());

}  // namespace obscura::stimuli
