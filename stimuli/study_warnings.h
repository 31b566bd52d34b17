// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stimuli/study.h"

namespace obscura::stimuli {

/// What is sound in a study but may not be what its author expects, a sentence each, naming the
/// scene: what of a scene's file is not shown or replaced (a missing texture), and settings that
/// have no effect at the scene's level. Files are told of where the study was read with
/// SceneFiles::kOpened.
[[nodiscard]] std::vector<std::string> warnings_of(const Study& study);

/// What a colleague would ask about, a sentence each: two variants that differ in one setting only,
/// a rule of exclusion that leaves nobody out.
[[nodiscard]] std::vector<std::string> notes_on(const Study& study);

}  // namespace obscura::stimuli
