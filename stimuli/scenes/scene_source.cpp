// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/scene_source.h"

#include <algorithm>

#include "renderer/base/error.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::stimuli {
namespace {

void append(std::string& list, std::string_view name) {
    if (!list.empty()) list += ", ";
    list += name;
}

}  // namespace

const renderer::Camera& SourcedScene::camera(const std::string& name) const {
    if (name.empty() && !scene.cameras.empty()) return scene.cameras.front();
    if (const renderer::Camera* found = scene.find_camera(name)) return *found;
    std::string known;
    for (const renderer::Camera& candidate : scene.cameras) append(known, candidate.name);
    throw base::bad_input("--camera: scene {} has no camera \"{}\"; it has {}", id, name,
                          known.empty() ? "none" : known);
}

Validity SourcedScene::level(const std::string& name) const {
    if (name.empty()) return levels.front();
    std::string known;
    for (const Validity level : levels) {
        if (to_string(level) == name) return level;
        append(known, to_string(level));
    }
    throw base::bad_input("--validity: scene {} has no level \"{}\"; it has {}", id, name, known);
}

SourcedScene load_scene_source(const std::string& source) {
    const BuiltinScene* builtin = find_builtin_scene(source);
    if (builtin == nullptr) {
        std::string known;
        for (const BuiltinScene& scene : builtin_scenes()) append(known, scene.id);
        throw base::bad_input("--scene: there is no scene \"{}\"; built in are {}", source, known);
    }
    SourcedScene sourced{builtin->id, builtin->build(), builtin->levels, builtin->lighting};
    if (sourced.scene.triangle_count() == 0) {
        throw base::bad_input("--scene: scene {} has no triangles", source);
    }
    return sourced;
}

}  // namespace obscura::stimuli
