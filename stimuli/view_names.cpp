// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/view_names.h"

#include <fmt/format.h>

#include <tuple>

namespace obscura::stimuli {

std::map<std::string, std::string> view_names(const Study& study) {
    std::map<std::tuple<std::string, std::string, std::string>, std::string> known;
    std::map<std::string, std::string> names;
    for (const StudyScene& scene : study.scenes) {
        SceneSettings geometry;
        geometry.scale = scene.settings.scale;
        geometry.camera = scene.settings.camera;
        const std::string settings = to_json(geometry);
        const std::string name = settings == "{}"
                                     ? fmt::format("{}, camera {}", scene.source, scene.camera)
                                     : fmt::format("{} as in {}", scene.source, scene.id);
        const auto [view, is_new] =
            known.emplace(std::tuple(scene.source, scene.camera, settings), name);
        names.emplace(scene.id, view->second);
    }
    return names;
}

}  // namespace obscura::stimuli
