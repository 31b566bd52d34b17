// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/builtin_scene.h"

#include "stimuli/scenes/list.h"

namespace obscura::stimuli {

const std::vector<BuiltinScene>& builtin_scenes() {
    static const std::vector<BuiltinScene> list = {
        make_figures(), make_atrium(), make_relic(), make_machine(), make_room(), make_garden(),
    };
    return list;
}

const BuiltinScene* find_builtin_scene(std::string_view id) {
    for (const BuiltinScene& scene : builtin_scenes()) {
        if (scene.id == id) return &scene;
    }
    return nullptr;
}

}  // namespace obscura::stimuli
