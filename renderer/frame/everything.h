// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/frame/plan.h"
#include "renderer/light/lighting.h"

namespace obscura::renderer {

/// The same light with parts added that change nothing: an environment of the constant ambient
/// light, a black directional light, a tone curve that only clips. With needs_of_everything it
/// gives the same surfaces from a frame that leaves nothing out: what leaving out saves.
[[nodiscard]] Lighting with_everything(const Lighting& lighting);

/// needs_of, with every part of a material asked for.
[[nodiscard]] SceneNeeds needs_of_everything(const Scene& scene, const Lighting& lighting);

}  // namespace obscura::renderer
