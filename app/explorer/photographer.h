// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/explorer/shot.h"
#include "renderer/frame/gpu_scene.h"
#include "renderer/frame/renderer.h"

namespace obscura::app::explorer {

/// Thrown where the caller wanted no more.
struct Stopped {};

/// Renders views by the one renderer that `obscura render` has. Needs a current OpenGL context;
/// keeps the scene of the last image, and of the last view what does not depend on the technique.
class Photographer {
  public:
    /// `wanted` is asked now and then during rays; false stops them with Stopped. Throws what the
    /// renderer throws.
    [[nodiscard]] Shot take(const ShotRequest& request, char side,
                            const std::function<bool()>& wanted);

  private:
    void load(const ShotRequest& request);

    renderer::Renderer renderer_;
    std::shared_ptr<LoadedScene> scene_;
    std::unique_ptr<renderer::GpuScene> gpu_;
    std::string light_key_;
    renderer::Lighting lighting_;
    renderer::ViewBuffers known_;
    std::string known_key_;  ///< the view, size and options that known_ is of
    renderer::Camera known_camera_;
};

}  // namespace obscura::app::explorer
