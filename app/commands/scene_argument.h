// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/commands/options.h"
#include "renderer/scene/scene.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app {

/// A scene as a command line names it.
struct SceneArgument {
    std::string scene;
    double scale = 1.0;

    /// Throws bad input as stimuli::open_scene does.
    [[nodiscard]] stimuli::OpenedScene open() const;
};

/// Says what of a scene's file is not shown, or otherwise.
void say_notes(const stimuli::OpenedScene& opened);

/// The word SCENE, which must be there, and --scale.
void add_scene(const Options& app, SceneArgument& argument);
/// --scene and --scale, of a command to which a scene is one thing among others.
void add_scene_option(const Options& app, SceneArgument& argument);

/// --validity, the level of a scene's light; `otherwise` says which where nothing is said.
void add_validity(const Options& app, std::string& validity, const std::string& otherwise);

/// Cameras as a command line names or describes them.
struct CameraArguments {
    std::vector<std::string> names;
    std::string position;
    std::string look_at;
    double fov_deg = 45.0;
};

/// --camera, --position, --look-at and --fov.
void add_cameras(const Options& app, CameraArguments& arguments);

/// The cameras that are named, or the one that is described. Where nothing is said the scene's
/// first own one, or the best view of a file that has none. Throws bad input naming the option.
[[nodiscard]] std::vector<renderer::Camera> cameras_of(const CameraArguments& arguments,
                                                       const stimuli::OpenedScene& opened);

/// Its line in a study file: `camera = "nave"`, or all of one that is described.
[[nodiscard]] std::string line_of(const renderer::Camera& camera);

}  // namespace obscura::app
