// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/import/import.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/scenes/scene_settings.h"

namespace obscura::stimuli {

/// A scene ready to be rendered, wherever it came from.
struct OpenedScene {
    std::string id;  ///< of the built-in scene, or the file's name without folder and ending
    std::string title;
    bool builtin = true;
    bool has_sides = true;  ///< whether its file can say that a surface has one side only
    std::shared_ptr<const renderer::Scene> scene;
    std::vector<Validity> levels;    ///< those that there is light for
    std::vector<std::string> notes;  ///< what is not shown, or otherwise than the file says
    std::vector<renderer::ImportedFile> files;  ///< that it was read from; none when built in
    /// The light at one of `levels`.
    std::function<renderer::Lighting(Validity)> lighting;

    /// The camera of that name, the first one for "". Throws bad input naming those there are.
    [[nodiscard]] const renderer::Camera& camera(const std::string& name = {}) const;
    /// False of a file without any camera, to which one that frames everything was given.
    [[nodiscard]] bool has_own_camera() const;
    /// The level of that name, the first one for "". Throws bad input naming those there are.
    [[nodiscard]] Validity level(const std::string& name = {}) const;
};

/// The folders from which files that a scene names may be read, beside the scene's own: what the
/// person at the command line permits this run (--allow). None until said; say it before any scene
/// is opened.
void allow_folders(std::vector<std::filesystem::path> folders);

/// Whether the source is a file's name: it holds a '/' or ends in .gltf, .glb or .obj.
[[nodiscard]] bool is_file_source(const std::string& source);

/// A built-in scene by its id, or a glTF or OBJ file by its path, relative to `folder`; what
/// `settings` say replaces the scene's own. Throws bad input: neither, a file that cannot be
/// read (renderer/import/import.h), an environment that cannot.
///
/// Light of a file's scene: `low` is ambient light of 1 from everywhere; `moderate` the given
/// environment, else a procedural sky; `high` that and the study's lights, else the file's, else a
/// sun, with normal maps. An environment from a file and the level `high` bring tone mapping.
[[nodiscard]] OpenedScene open_scene(const std::string& id_or_file,
                                     const SceneSettings& settings = {},
                                     const std::filesystem::path& folder = {},
                                     const std::vector<BuiltinScene>& catalogue = builtin_scenes());

/// The levels that a scene has light for when the settings are added to its own: ambient light
/// makes `low`, an environment `moderate`, lights of the study with any environment `high`.
[[nodiscard]] std::vector<Validity> levels_with(const std::vector<Validity>& own,
                                                const SceneSettings& settings);

/// The scene's own light at a level with what the settings replace of it. Throws bad input for an
/// environment that cannot be read.
[[nodiscard]] renderer::Lighting with_settings(renderer::Lighting lighting, Validity validity,
                                               const SceneSettings& settings,
                                               const std::filesystem::path& folder);

}  // namespace obscura::stimuli
