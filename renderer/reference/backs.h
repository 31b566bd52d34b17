// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// Which surfaces' backs count: those that are not drawn, or all.
enum class Backs { kOfSingleSided, kAll };

/// For each camera the share of what it sees, in a wide image of 96x54 rays, that is turned away
/// from it: of the first surfaces that rays meet, from whichever side, those that they meet from
/// behind; [0, 1], 0 where it sees nothing. Cut-outs have their holes, blended surfaces are not
/// there. Throws bad input for a camera that is not allowed.
[[nodiscard]] std::vector<double> shares_of_backs(const Scene& scene,
                                                  const std::vector<Camera>& cameras, Backs backs);

}  // namespace obscura::renderer
