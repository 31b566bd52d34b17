// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::renderer {

/// An OpenGL 4.5 core context without window or X server (EGL, surfaceless), current on the thread
/// that made it until destroyed. Everything else in the renderer only needs *some* current context,
/// so the kiosk's window serves as well.
class HeadlessContext {
  public:
    /// Throws failure naming the step, EGL's reason and the driver package that is missing.
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

  private:
    void* display_ = nullptr;  // EGLDisplay
    void* context_ = nullptr;  // EGLContext
};

/// GL_RENDERER of the current context.
[[nodiscard]] std::string gpu_renderer();

/// Whether the current context renders on the CPU (llvmpipe, softpipe, SwiftShader), where the
/// driver's timers are wrong.
[[nodiscard]] bool is_software_renderer();

/// GL_RENDERER and GL_VERSION, one line; the driver's version may change an image.
[[nodiscard]] std::string gpu_description();

}  // namespace obscura::renderer
