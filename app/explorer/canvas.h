// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "renderer/gl/handles.h"

struct ImDrawData;

namespace obscura::app::explorer {

/// What Dear ImGui draws, kept from frame to frame, so that only those of its windows are drawn
/// again that do not look as before: a software renderer takes longer for the panels than for the
/// image beside them. Needs the window's context for as long as it lives.
class Canvas {
  public:
    /// Draws what changed, and all of it into the window's framebuffer, of that size in pixels.
    void show(ImDrawData& data, glm::ivec2 size_px, const glm::vec3& ground);
    /// Everything is drawn again the next time: the fonts are others.
    void forget() { drawn_.clear(); }

    /// From the upper left corner, in pixels.
    struct Area {
        glm::ivec2 low{0};
        glm::ivec2 high{0};
        [[nodiscard]] bool operator==(const Area&) const = default;
        [[nodiscard]] bool empty() const { return high.x <= low.x || high.y <= low.y; }
    };
    /// A window of Dear ImGui as it was drawn.
    struct Drawn {
        std::string name;
        std::size_t looks = 0;  ///< a number that differs where it looks otherwise
        bool pictures = false;  ///< it shows textures, which may change unseen
        Area area;
    };
    /// What has to be drawn again, of an image of that size.
    [[nodiscard]] static std::vector<Area> changed(const std::vector<Drawn>& before,
                                                   const std::vector<Drawn>& now,
                                                   glm::ivec2 size_px);

  private:
    renderer::gl::Texture texture_;
    renderer::gl::Framebuffer framebuffer_;
    glm::ivec2 size_px_{0};
    std::vector<Drawn> drawn_;
};

}  // namespace obscura::app::explorer
