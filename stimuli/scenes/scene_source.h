// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"
#include "stimuli/validity.h"

namespace obscura::stimuli {

/// A scene with its light, wherever it comes from.
struct SourcedScene {
    std::string id;
    renderer::Scene scene;
    std::vector<Validity> levels;                          ///< at least one
    std::function<renderer::Lighting(Validity)> lighting;  ///< for one of `levels`

    /// The camera of that name, the first for "". Throws bad input naming those there are.
    [[nodiscard]] const renderer::Camera& camera(const std::string& name) const;
    /// The level of that name, the first for "". Throws bad input naming those there are.
    [[nodiscard]] Validity level(const std::string& name) const;
};

/// Builds the scene that a command line calls by `source`: the id of a built-in scene. Throws bad
/// input naming the built-in scenes when there is no such scene, and for one without triangles.
[[nodiscard]] SourcedScene load_scene_source(const std::string& source);

}  // namespace obscura::stimuli
