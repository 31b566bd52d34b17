// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/view_area.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/explorer/flight.h"
#include "renderer/passes/shared_constants.h"

namespace obscura::app::explorer {
namespace {

constexpr ImU32 kLabel = IM_COL32(20, 22, 26, 215);
constexpr ImU32 kOnLabel = IM_COL32(250, 250, 252, 255);
constexpr ImU32 kFrame = IM_COL32(255, 196, 0, 255);

[[nodiscard]] ImVec2 im(const glm::vec2& v) { return {v.x, v.y}; }
[[nodiscard]] glm::vec2 gl(const ImVec2& v) { return {v.x, v.y}; }

[[nodiscard]] Box cell_of(const Box& area, std::size_t number) {
    const glm::vec2 half = glm::floor(0.5F * area.size());
    const glm::vec2 at{number % 2 == 0 ? 0.0F : half.x, number < 2 ? 0.0F : half.y};
    return {area.low + at, area.low + at + half};
}

[[nodiscard]] glm::vec2 image_px(const Choices& choices) {
    return {static_cast<float>(choices.width), static_cast<float>(choices.height)};
}

/// Depth of what is at a pixel; how far the camera's target is where nothing is known.
[[nodiscard]] float depth_at(const Model& model, const glm::vec2& pixel) {
    const renderer::Camera& camera = model.view().camera;
    const float otherwise = glm::length(camera.target_m - camera.position_m);
    for (const char side : {'a', 'b'}) {
        const auto shot = model.buffers(side);
        const std::vector<float>* depth = shot ? shot->buffers.find("Z") : nullptr;
        if (depth == nullptr) continue;
        const int x = std::clamp(static_cast<int>(pixel.x), 0, shot->width - 1);
        const int y = std::clamp(static_cast<int>(pixel.y), 0, shot->height - 1);
        const float z =
            (*depth)[static_cast<std::size_t>(y) * static_cast<std::size_t>(shot->width) +
                     static_cast<std::size_t>(x)];
        return z < kBackgroundLimit_m ? z : otherwise;
    }
    return otherwise;
}

void draw_scale(const Scale& scale, const glm::vec2& right_bottom) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float text = ImGui::GetFontSize();
    const glm::vec2 size{12.0F * text, 0.8F * text};
    const glm::vec2 low = right_bottom - glm::vec2(size.x + 1.2F * text, size.y + 2.0F * text);
    list.AddRectFilled(im(low - 0.6F * text), im(right_bottom - 0.3F * text), kLabel);
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / kSteps;
        const float shown = scale.diverging ? 2.0F * share - 1.0F : share;
        const Rgb rgb = scale.colour(shown);
        const float left = low.x + size.x * static_cast<float>(i) / kSteps;
        const float right = low.x + size.x * static_cast<float>(i + 1) / kSteps;
        list.AddRectFilled({left, low.y}, {right, low.y + size.y},
                           IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    }
    for (const float share : {0.0F, 0.5F, 1.0F}) {
        const float value = scale.low + share * (scale.high - scale.low);
        const std::string number = scale.diverging && value != 0.0F
                                       ? fmt::format("{:+.2g}", value)
                                       : fmt::format("{:.3g}{}", value, scale.unit);
        const float width = ImGui::CalcTextSize(number.c_str()).x;
        list.AddText({low.x + share * (size.x - width), low.y + size.y + 0.1F * text}, kOnLabel,
                     number.c_str());
    }
}

}  // namespace

Placement placed(const Box& pane, const glm::vec2& image, const Layout& layout) {
    Placement placement;
    const glm::vec2 room = glm::max(pane.size(), glm::vec2(1.0F));
    const float fits = std::min(room.x / image.x, room.y / image.y);
    placement.scale = layout.zoom > 0.0F ? layout.zoom : fits;
    const glm::vec2 middle = layout.zoom > 0.0F ? layout.middle : glm::vec2(0.5F);
    placement.origin = pane.low + 0.5F * room - placement.scale * middle * image;
    if (layout.zoom >= 1.0F) placement.origin = glm::round(placement.origin);
    return placement;
}

const ViewArea::Slot& ViewArea::slot_of(Desk& desk, const Pane& pane) {
    constexpr double kTruthEvery_s = 0.5;
    Slot& slot = slots_[pane.side + pane.layer];
    auto shot = needs_buffers(pane.layer) ? desk.model.buffers(pane.side) : nullptr;
    if (!shot) shot = desk.model.image(pane.side);
    std::shared_ptr<const Truth> truth;
    if (needs_truth(pane.layer)) {
        truth = desk.model.truth();
        const bool soon = slot.truth && truth && desk.now_s - slot.made_s < kTruthEvery_s;
        if (soon && slot.truth->width() == truth->width()) truth = slot.truth;
    }
    const Layout& layout = desk.model.layout();
    const bool same_scale = slot.layout.error_range == layout.error_range &&
                            slot.layout.depth_low_m == layout.depth_low_m &&
                            slot.layout.depth_high_m == layout.depth_high_m;
    if (shot == slot.shot && truth == slot.truth && same_scale) return slot;
    slot.shot = shot;
    slot.truth = truth;
    slot.layout = layout;
    slot.made_s = desk.now_s;
    if (!shot) {
        slot.texture = {};
        slot.why_not = "Nothing is rendered yet.";
        return slot;
    }
    Picture picture = picture_of(*shot, truth.get(), pane.layer, layout);
    slot.why_not = picture.why_not;
    slot.scale = picture.scale;
    if (picture.image.width == 0) {
        slot.texture = {};
        return slot;
    }
    const bool fits =
        slot.texture && slot.width == picture.image.width && slot.height == picture.image.height;
    slot.width = picture.image.width;
    slot.height = picture.image.height;
    if (!fits) {
        slot.texture = renderer::gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
        glTextureStorage2D(slot.texture.name(), 1, GL_RGB8, slot.width, slot.height);
        glTextureParameteri(slot.texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(slot.texture.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTextureParameteri(slot.texture.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(slot.texture.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glTextureSubImage2D(slot.texture.name(), 0, 0, 0, slot.width, slot.height, GL_RGB,
                        GL_UNSIGNED_BYTE, picture.image.rgb.data());
    return slot;
}

void ViewArea::draw_label(Desk& desk, const Box& clip, const Pane& pane, const Slot& slot,
                          bool right) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string text =
        fmt::format("{}  {}  {}", pane.side == 'a' ? "A" : "B",
                    desk.model.choices().side(pane.side).variant_name(), pane.layer);
    const glm::vec2 size = gl(ImGui::CalcTextSize(text.c_str()));
    const float pad = 0.4F * ImGui::GetFontSize();
    const float left = right ? clip.high.x - size.x - 2.0F * pad : clip.low.x;
    const glm::vec2 low{left, clip.low.y};
    list.AddRectFilled(im(low), im(low + size + 2.0F * pad), kLabel);
    list.AddText(im(low + pad), kOnLabel, text.c_str());
    if (!slot.why_not.empty()) {
        const glm::vec2 middle = 0.5F * (clip.low + clip.high);
        const glm::vec2 half = 0.5F * gl(ImGui::CalcTextSize(slot.why_not.c_str()));
        list.AddRectFilled(im(middle - half - pad), im(middle + half + pad), kLabel);
        list.AddText(im(middle - half), kOnLabel, slot.why_not.c_str());
    }
    if (slot.scale.colour != nullptr && slot.texture) draw_scale(slot.scale, clip.high);
}

void ViewArea::draw_pane(Desk& desk, const Box& box, const Box& clip, const Pane& pane) {
    const Slot& slot = slot_of(desk, pane);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(im(clip.low), im(clip.high), true);
    const glm::vec2 image = image_px(desk.model.choices());
    const Placement placement = placed(box, image, desk.model.layout());
    if (slot.texture) {
        const glm::vec2 high = placement.origin + placement.scale * image;
        // It covers what is under it: blending would only cost a software renderer's time.
        list.AddCallback([](const ImDrawList*, const ImDrawCmd*) { glDisable(GL_BLEND); }, nullptr);
        list.AddImage(reinterpret_cast<void*>(static_cast<std::uintptr_t>(slot.texture.name())),
                      im(placement.origin), im(high));
        list.AddCallback([](const ImDrawList*, const ImDrawCmd*) { glEnable(GL_BLEND); }, nullptr);
    }
    if (const auto& region = desk.model.region()) {
        const glm::vec2 low =
            placement.origin + placement.scale * glm::vec2(region->left, region->top);
        const glm::vec2 size = placement.scale * glm::vec2(region->width, region->height);
        list.AddRect(im(low), im(low + size), kFrame, 0.0F, 0, 2.0F);
    }
    draw_label(desk, clip, pane, slot, clip.low.x > box.low.x);
    list.PopClipRect();
}

void ViewArea::draw(Desk& desk, const Box& area) {
    ImGui::SetNextWindowPos(im(area.low));
    ImGui::SetNextWindowSize(im(glm::max(area.size(), glm::vec2(1.0F))));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::Begin("##view", nullptr,
                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoDecoration |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoScrollWithMouse);
    const Layout& layout = desk.model.layout();
    const std::vector<Pane> panes = layout.visible(desk.now_s);
    const bool four = layout.arrangement == Arrangement::kFour;
    const glm::vec2 room = glm::max((four ? cell_of(area, 0) : area).size(), glm::vec2(1.0F));
    const glm::vec2 fits = room / image_px(desk.model.choices());
    desk.state.whole_zoom = std::min(fits.x, fits.y);
    if (layout.arrangement == Arrangement::kSplit) {
        const float line = std::round(area.low.x + layout.split * area.size().x);
        draw_pane(desk, area, {area.low, {line, area.high.y}}, panes[0]);
        draw_pane(desk, area, {{line, area.low.y}, area.high}, panes[1]);
        ImGui::GetWindowDrawList()->AddLine({line, area.low.y}, {line, area.high.y}, kFrame, 2.0F);
    } else if (layout.arrangement == Arrangement::kFour) {
        for (std::size_t i = 0; i < panes.size(); ++i) {
            const Box cell = cell_of(area, i);
            draw_pane(desk, cell, cell, panes[i]);
            if (static_cast<int>(i) == desk.state.active_pane) {
                ImGui::GetWindowDrawList()->AddRect(im(cell.low), im(cell.high), kFrame);
            }
        }
    } else {
        draw_pane(desk, area, area, panes[0]);
    }
    mouse(desk, area);
    ImGui::End();
    ImGui::PopStyleVar(2);
}

Box ViewArea::box_under(const Desk& desk, const Box& area, const glm::vec2& at) const {
    if (desk.model.layout().arrangement != Arrangement::kFour) return area;
    for (std::size_t i = 0; i < 4; ++i) {
        if (cell_of(area, i).holds(at)) return cell_of(area, i);
    }
    return area;
}

void ViewArea::mouse(Desk& desk, const Box& area) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 at = gl(io.MousePos);
    const bool over = ImGui::IsWindowHovered() && area.holds(at);
    desk.state.pointer_px.reset();
    if (over) {
        const Placement placement =
            placed(box_under(desk, area, at), image_px(desk.model.choices()), desk.model.layout());
        desk.state.pointer_px = placement.pixel_at(at);
    }
    // The way to where it was pressed drags nothing.
    bool pressed = false;
    for (int button = 0; button < 3; ++button) {
        if (drag_ == Drag::kNone && over && ImGui::IsMouseClicked(button)) {
            press(desk, area, button, at);
            pressed = true;
        }
    }
    if (drag_ != Drag::kNone && !pressed) {
        // The last of a way may come with the release, where frames are slow.
        if (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) {
            drag(desk, area, at, gl(io.MouseDelta));
        }
        if (!io.MouseDown[button_]) drag_ = Drag::kNone;
    }
    if (over && io.MouseWheel != 0.0F) wheel(desk, area, at);
}

void ViewArea::press(Desk& desk, const Box& area, int button, const glm::vec2& at) {
    const Layout& layout = desk.model.layout();
    pane_ = box_under(desk, area, at);
    button_ = button;
    desk.state.keys_in_panels = false;
    const glm::vec2 image = image_px(desk.model.choices());
    began_px_ = placed(pane_, image, layout).pixel_at(at);
    if (layout.arrangement == Arrangement::kFour) {
        for (int i = 0; i < 4; ++i) {
            if (cell_of(area, static_cast<std::size_t>(i)).holds(at)) desk.state.active_pane = i;
        }
    }
    const float line = area.low.x + layout.split * area.size().x;
    const bool on_line = layout.arrangement == Arrangement::kSplit &&
                         std::abs(at.x - line) < 0.5F * ImGui::GetFontSize();
    if (button == 0 && ImGui::GetIO().KeyShift) {
        drag_ = Drag::kRegion;
        desk.model.set_region(std::nullopt);
    } else if (button == 0 && on_line) {
        drag_ = Drag::kLine;
    } else if (button == 0) {
        drag_ = Drag::kTurn;
    } else if (button == 1) {
        drag_ = Drag::kOrbit;
        about_m_ = point_at(upright(desk.model.view().camera), desk.model.aspect(),
                            began_px_ / image, depth_at(desk.model, began_px_));
    } else {
        drag_ = Drag::kPan;
    }
}

void ViewArea::drag(Desk& desk, const Box& area, const glm::vec2& at, const glm::vec2& by) {
    Model& model = desk.model;
    const glm::vec2 image = image_px(model.choices());
    Layout layout = model.layout();
    const Placement placement = placed(pane_, image, layout);
    // As far as the pointer moved in the image, near enough.
    const glm::vec2 turn_rad =
        model.view().camera.vertical_fov_rad * by / (placement.scale * image.y);
    switch (drag_) {
        case Drag::kTurn:
            model.look_from(turned(model.view().camera, turn_rad.x, -turn_rad.y), desk.now_s);
            break;
        case Drag::kOrbit: {
            const glm::vec2 orbit_rad = 5.0F * by / glm::max(area.size(), glm::vec2(1.0F));
            model.look_from(orbited(model.view().camera, about_m_, -orbit_rad.x, -orbit_rad.y),
                            desk.now_s);
            break;
        }
        case Drag::kPan:
            layout.middle -= by / (placement.scale * image);
            model.set_layout(layout, desk.now_s);
            break;
        case Drag::kLine:
            layout.split = (at.x - area.low.x) / std::max(area.size().x, 1.0F);
            model.set_layout(layout, desk.now_s);
            break;
        case Drag::kRegion: {
            const glm::vec2 to = placement.pixel_at(at);
            const glm::vec2 low =
                glm::floor(glm::clamp(glm::min(began_px_, to), glm::vec2(0.0F), image));
            const glm::vec2 high =
                glm::ceil(glm::clamp(glm::max(began_px_, to), glm::vec2(0.0F), image));
            model.set_region(Region{static_cast<int>(low.x), static_cast<int>(low.y),
                                    static_cast<int>(high.x - low.x),
                                    static_cast<int>(high.y - low.y)});
            break;
        }
        case Drag::kNone:
            break;
    }
}

void ViewArea::wheel(Desk& desk, const Box& area, const glm::vec2& at) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.KeyCtrl) {
        const float factor = std::pow(1.2F, std::clamp(io.MouseWheel, -10.0F, 10.0F));
        desk.state.speed_m_s = std::clamp(desk.state.speed_m_s * factor, 1e-3F, 1e3F);
        return;
    }
    const glm::vec2 image = image_px(desk.model.choices());
    const Box pane = box_under(desk, area, at);
    Layout layout = desk.model.layout();
    const Placement before = placed(pane, image, layout);
    const glm::vec2 pixel = before.pixel_at(at);
    layout.zoom = next_zoom(layout.zoom, io.MouseWheel > 0.0F, desk.state.whole_zoom);
    if (layout.zoom > 0.0F) {
        layout.middle = (pixel + (0.5F * (pane.low + pane.high) - at) / layout.zoom) / image;
    }
    desk.model.set_layout(layout, desk.now_s);
}

}  // namespace obscura::app::explorer
