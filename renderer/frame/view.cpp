// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/view.h"

namespace obscura::renderer {

FramePlan plan_of(const View& view, const Variant& choice, int width, int height) {
    const SceneNeeds needs =
        view.needs.value_or(needs_of(view.scene.materials(), view.scene.bounds(), view.lighting));
    return plan_frame(needs, choice, width, height, view.options);
}

}  // namespace obscura::renderer
