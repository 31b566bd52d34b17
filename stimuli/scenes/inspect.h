// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/technique.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::stimuli {

/// One paragraph for a scene: what it is, triangles, cameras, levels and what its surfaces ask of
/// the renderer.
[[nodiscard]] std::string summary_of(const OpenedScene& scene);

/// What somebody who wants to show a scene asks first: how large it is in metres, its cameras as
/// lines for a study file, its levels of light, and everything that is not shown or otherwise.
[[nodiscard]] std::string overview_of(const OpenedScene& scene);

/// What is not shown of a scene or otherwise, and what its own cameras see from behind.
[[nodiscard]] std::vector<std::string> notes_on(const OpenedScene& scene);

/// All of a scene: triangles, bounds, materials, textures with bytes, cameras, lights, what is not
/// shown or otherwise, and for each level the passes and buffers of an image of width x height
/// with that technique, and what is left out, why. Throws bad input for a choice or a size that is
/// not allowed.
[[nodiscard]] std::string inspection_of(const OpenedScene& scene, const renderer::Variant& choice,
                                        int width, int height);

}  // namespace obscura::stimuli
