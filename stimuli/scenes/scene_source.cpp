// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/scene_source.h"

#include <memory>
#include <utility>

#include "renderer/base/error.h"

namespace obscura::stimuli {
namespace {

void append(std::string& list, std::string_view name) {
    if (!list.empty()) list += ", ";
    list += name;
}

}  // namespace

std::string SceneSource::camera_for(const std::string& name) const {
    if (name.empty()) return cameras.front();
    std::string known;
    for (const std::string& camera : cameras) {
        if (camera == name) return camera;
        append(known, camera);
    }
    throw base::bad_input("--camera: scene {} has no camera \"{}\"; it has {}", id, name, known);
}

Validity SceneSource::level_for(const std::string& name) const {
    if (name.empty()) return levels.front();
    std::string known;
    for (const Validity level : levels) {
        if (to_string(level) == name) return level;
        append(known, to_string(level));
    }
    throw base::bad_input("--validity: scene {} has no level \"{}\"; it has {}", id, name, known);
}

SceneSource source_of(OpenedScene scene, const std::string& source) {
    const auto opened = std::make_shared<const OpenedScene>(std::move(scene));
    SceneSource found;
    found.id = opened->id;
    found.source = source;
    for (const renderer::Camera& camera : opened->scene->cameras) {
        found.cameras.push_back(camera.name);
    }
    found.levels = opened->levels;
    found.notes = opened->notes;
    found.build = [opened] { return *opened->scene; };
    found.lighting = [opened](Validity level) {
        return opened->with_probes(opened->lighting(level));
    };
    return found;
}

SceneSource find_scene_source(const std::string& source) {
    return source_of(open_scene(source), source);
}

}  // namespace obscura::stimuli
