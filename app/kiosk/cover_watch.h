// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

struct GLFWwindow;

namespace obscura::app::kiosk {

/// Whether other windows cover a window, which GLFW does not tell: by VisibilityNotify of the X
/// server, on a connection of its own. A compositing window manager draws every window apart, so
/// the server calls none of them covered; what lies before a window is not known then, only that
/// it lost the focus. Nor is it known what covered the window before this watch began.
///
/// It also tells GLFW of a new layout of the keyboard.
class CoverWatch {
  public:
    /// `window` must outlive it. Where there is no X server, nothing is ever covered.
    explicit CoverWatch(GLFWwindow* window);
    ~CoverWatch();
    CoverWatch(const CoverWatch&) = delete;
    CoverWatch& operator=(const CoverWatch&) = delete;

    /// Whether any of it is covered, or beyond the edge of the screen; as of the last event.
    [[nodiscard]] bool covered();

  private:
    void* connection_ = nullptr;  ///< Display*; Xlib's names collide with ours
    bool covered_ = false;
};

}  // namespace obscura::app::kiosk
