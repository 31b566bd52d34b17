// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/scenes/validity.h"

namespace obscura::stimuli {

/// A scene with its light, wherever it comes from, before it is built.
struct SceneSource {
    std::string id;                    ///< built-in scene's, or the file's name without ending
    std::string source;                ///< as study file and command line name it
    std::vector<std::string> cameras;  ///< at least one, as build() names them
    std::vector<Validity> levels;      ///< at least one
    std::function<renderer::Scene()> build;
    /// For one of `levels`, with probes; those of a scene that is not opened yet are to be baked.
    std::function<renderer::Lighting(Validity)> lighting;
    std::vector<std::string> notes = {};  ///< what of its file is not shown, or otherwise

    /// The name itself, the first camera's for "". Throws bad input naming those there are.
    [[nodiscard]] std::string camera_for(const std::string& name) const;
    /// The level of that name, the first for "". Throws bad input naming those there are.
    [[nodiscard]] Validity level_for(const std::string& name) const;
};

/// A scene that is opened already.
[[nodiscard]] SceneSource source_of(OpenedScene opened, const std::string& source);

/// What a command line calls by `--scene`: the id of a built-in scene, or a glTF or OBJ file.
/// Throws bad input as open_scene does.
[[nodiscard]] SceneSource find_scene_source(const std::string& source);

}  // namespace obscura::stimuli
