// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "renderer/reference/exr.h"
#include "renderer/reference/reference.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app {

/// Makes accessibility buffers of views of one scene. An OpenGL context is made for those that need
/// one.
class AoBuffers {
  public:
    struct Settings {
        std::filesystem::path cache;  ///< of ray-traced buffers
        int width = 0;
        int height = 0;
        bool quiet = false;
    };
    AoBuffers(const stimuli::OpenedScene& opened, stimuli::Validity validity, Settings settings)
        : opened_(opened), validity_(validity), settings_(std::move(settings)) {}

    /// Channel ao.Y, of the unfiltered reference also ao.stderr, with what it is of.
    [[nodiscard]] renderer::FloatImage make(const renderer::Camera& camera,
                                            const renderer::Variant& variant);

    /// Ray traced. The first Ctrl-C stops the work, the second the program.
    [[nodiscard]] renderer::ReferenceImage trace(const renderer::Camera& camera,
                                                 const renderer::ReferenceOptions& options);

  private:
    /// By the passes of a frame, as an image of a study has it.
    std::vector<float> rendered(const renderer::Camera& camera, const renderer::Variant& variant);
    const renderer::ReferenceScene& rays();

    const stimuli::OpenedScene& opened_;
    stimuli::Validity validity_;
    Settings settings_;
    std::unique_ptr<renderer::ReferenceScene> rays_;
    std::unique_ptr<renderer::HeadlessContext> context_;  // outlives what was made in it
    std::unique_ptr<renderer::Renderer> renderer_;
    std::unique_ptr<renderer::GpuScene> gpu_;
};

}  // namespace obscura::app
