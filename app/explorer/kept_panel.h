// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "renderer/gl/handles.h"

struct ImDrawData;
struct ImDrawList;

namespace obscura::app::explorer {

/// A window of Dear ImGui and where it is, in pixels.
struct PanelPlace {
    std::string name;
    glm::vec2 low{0.0F};
    glm::vec2 high{0.0F};
};

/// A picture of a panel that may be a moment old. Its many letters and frames take a software
/// renderer four times as long as one picture of them, and that time from the next image. Needs
/// the window's context.
class KeptPanel {
  public:
    KeptPanel();
    ~KeptPanel();
    KeptPanel(const KeptPanel&) = delete;
    KeptPanel& operator=(const KeptPanel&) = delete;

    /// Draws the picture in place of the panel, taking it anew where it is too old; a frame that
    /// lacks the panel stays as it is.
    void put_picture(ImDrawData& frame, const PanelPlace& panel, double now_s);
    /// The next picture is taken anew.
    void forget() { made_s_ = -1.0; }

  private:
    void take_picture(const ImDrawData& frame, ImDrawList* list, const PanelPlace& panel);

    renderer::gl::Texture texture_;
    renderer::gl::Framebuffer framebuffer_;
    glm::ivec2 size_px_{0};
    double made_s_ = -1.0;
    std::unique_ptr<ImDrawList> picture_;  ///< what draws it
};

}  // namespace obscura::app::explorer
