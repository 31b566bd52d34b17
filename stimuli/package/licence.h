// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "stimuli/package/package.h"

namespace obscura::stimuli {

/// Of each scene of a study: what `licence` of its [[scene]] says, else what its file says of
/// itself (glTF 2.0, asset.copyright); that of a built-in scene is the program's. The text is one
/// that has been read as that study.
[[nodiscard]] std::vector<SceneLicence> licences_of(const Study& study, const std::string& text);

}  // namespace obscura::stimuli
