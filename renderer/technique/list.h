// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/technique/technique.h"

namespace obscura::renderer {

// One line a technique; each is defined in the file of its name.
Technique make_none();
Technique make_crytek();
Technique make_blizzard();
Technique make_raymarch();
Technique make_reference();

}  // namespace obscura::renderer
