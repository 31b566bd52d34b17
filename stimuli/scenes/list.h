// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "stimuli/scenes/builtin_scene.h"

namespace obscura::stimuli {

// One line a scene; each is defined in the file or folder of its name.
BuiltinScene make_atrium();
BuiltinScene make_figures();
BuiltinScene make_garden();
BuiltinScene make_machine();
BuiltinScene make_relic();
BuiltinScene make_room();

}  // namespace obscura::stimuli
