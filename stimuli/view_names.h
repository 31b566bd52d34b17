// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "stimuli/study.h"

namespace obscura::stimuli {

/// What each scene of a study looks at, by the scene's id: two scenes have the same name where
/// source, scale and camera are the same, whatever the light: `atrium, camera nave`. A view that
/// only the study describes is called by its source and the first scene that has it.
[[nodiscard]] std::map<std::string, std::string> view_names(const Study& study);

}  // namespace obscura::stimuli
