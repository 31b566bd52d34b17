// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/selection.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// Renders the selected images in memory and tells of each its passes with milliseconds (of the
/// middle one of up to four renderings, by how long they take), the range of those, its buffers
/// with bytes, how many texels the technique reads, and what was left out. Images of equal inputs
/// are told of once, and passes that images of one view share are measured with the first of them.
/// Ends with a table of milliseconds and bytes as planned and with nothing left out.
[[nodiscard]] std::string explain(const Study& study, const Selection& selection, bool quiet,
                                  const std::vector<BuiltinScene>& catalogue = builtin_scenes());

/// The same as a JSON array, an object for an image and its equals (`files`): passes with
/// milliseconds and the image that they were measured with, buffers with bytes, what was left out,
/// and the sums as planned and with nothing left out.
[[nodiscard]] std::string explain_json(
    const Study& study, const Selection& selection, bool quiet,
    const std::vector<BuiltinScene>& catalogue = builtin_scenes());

}  // namespace obscura::stimuli
