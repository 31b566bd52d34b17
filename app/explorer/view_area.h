// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/explorer/desk.h"
#include "app/explorer/picture.h"
#include "renderer/gl/handles.h"

namespace obscura::app::explorer {

/// A rectangle of the window, from its upper left corner.
struct Box {
    glm::vec2 low{0.0F};
    glm::vec2 high{0.0F};

    [[nodiscard]] glm::vec2 size() const { return high - low; }
    [[nodiscard]] bool holds(const glm::vec2& point) const {
        return point.x >= low.x && point.y >= low.y && point.x < high.x && point.y < high.y;
    }
};

/// Where an image of that many pixels lies in a pane.
struct Placement {
    glm::vec2 origin{0.0F};  ///< of its upper left corner, in the window
    float scale = 1.0F;      ///< window pixels of one of the image's

    [[nodiscard]] glm::vec2 pixel_at(const glm::vec2& point) const {
        return (point - origin) / scale;
    }
};
[[nodiscard]] Placement placed(const Box& pane, const glm::vec2& image_px, const Layout& layout);

/// The panes with their pictures, and what the mouse does in them. Needs the window's context.
class ViewArea {
  public:
    void draw(Desk& desk, const Box& area);
    /// Whether a button of the mouse holds something, so that the next frame should come soon.
    [[nodiscard]] bool dragging() const { return drag_ != Drag::kNone; }

  private:
    enum class Drag { kNone, kTurn, kOrbit, kPan, kRegion, kLine };
    /// A picture on the GPU and what it was made of.
    struct Slot {
        renderer::gl::Texture texture;
        std::shared_ptr<const Shot> shot;
        std::shared_ptr<const Truth> truth;
        Layout layout;
        double made_s = 0.0;
        int width = 0;
        int height = 0;
        Scale scale;
        std::string why_not;
    };

    const Slot& slot_of(Desk& desk, const Pane& pane);
    void draw_pane(Desk& desk, const Box& box, const Box& clip, const Pane& pane);
    void draw_label(Desk& desk, const Box& clip, const Pane& pane, const Slot& slot, bool right);
    void mouse(Desk& desk, const Box& area);
    void press(Desk& desk, const Box& area, int button, const glm::vec2& at);
    void drag(Desk& desk, const Box& area, const glm::vec2& at, const glm::vec2& by);
    void wheel(Desk& desk, const Box& area, const glm::vec2& at);
    [[nodiscard]] Box box_under(const Desk& desk, const Box& area, const glm::vec2& at) const;

    std::map<std::string, Slot> slots_;
    Drag drag_ = Drag::kNone;
    int button_ = 0;
    glm::vec2 began_px_{0.0F};  ///< of the drag, in the image
    glm::vec3 about_m_{0.0F};   ///< what is orbited
    Box pane_;                  ///< where the drag began
};

}  // namespace obscura::app::explorer
