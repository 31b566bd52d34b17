// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/explorer/shot.h"
#include "renderer/frame/gpu_scene.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"

namespace obscura::app::explorer {

/// Renders views by the one renderer that `obscura render` has. Needs a current OpenGL context;
/// keeps the scene of the last image, of the last view what does not depend on the technique, and
/// shadow maps for as long as only the camera moves. On a software renderer a scene of many
/// triangles is drawn coarser while something moves.
class Photographer {
  public:
    /// `wanted` is asked now and then; false ends the image with renderer::Stopped. Throws what the
    /// renderer throws.
    [[nodiscard]] Shot take(const ShotRequest& request, char side,
                            const std::function<bool()>& wanted);

    /// Loads and compiles what images in motion of that request's scene and techniques need, so
    /// that the first of them is as quick as the next.
    void get_ready_to_move(const ShotRequest& request, const std::function<bool()>& wanted);

  private:
    /// A scene on the GPU with what is known of the last view of it.
    struct Stage {
        std::unique_ptr<renderer::GpuScene> gpu;
        renderer::ViewBuffers known;
        std::string known_key;  ///< the size and options that `known` is of
        renderer::Camera known_camera;
    };
    void load(const ShotRequest& request);
    /// The scene itself, or what is drawn of it while something moves.
    Stage& stage_for(const ShotRequest& request);
    /// Lets go of what the image to come cannot take over.
    void forget_other_views(Stage& stage, const ShotRequest& request,
                            const renderer::FrameOptions& options, int width, int height) const;

    renderer::Renderer renderer_;
    const bool software_ = renderer::is_software_renderer();
    std::shared_ptr<LoadedScene> scene_;
    Stage whole_;
    Stage coarse_;
    std::string light_key_;
    std::string ready_key_;  ///< the light and techniques that it is ready to move with
    renderer::Lighting lighting_;
};

}  // namespace obscura::app::explorer
