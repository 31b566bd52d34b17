// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/loaded_scene.h"

#include <utility>

namespace obscura::app::explorer {

LoadedScene::LoadedScene(stimuli::OpenedScene opened)
    : opened_(std::move(opened)), bounds_(renderer::bounds_of(*opened_.scene)) {}

void LoadedScene::make_coarse(const std::function<bool()>& go_on) {
    if (coarse_made_) return;
    coarse_ = coarser(*opened_.scene, kMostMovingTriangles, go_on);
    coarse_made_ = coarse_.has_value();
}

const renderer::ReferenceScene& LoadedScene::rays() {
    const std::lock_guard lock(mutex_);
    if (!rays_) rays_ = std::make_unique<renderer::ReferenceScene>(*opened_.scene);
    return *rays_;
}

}  // namespace obscura::app::explorer
