// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/controls.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "app/explorer/cost_text.h"
#include "app/explorer/fields.h"
#include "app/explorer/flight.h"
#include "app/explorer/gamepad.h"
#include "app/explorer/keys.h"
#include "app/window/letters.h"

namespace obscura::app::explorer {
namespace {

constexpr float kTurn_rad_s = 1.2F;
constexpr float kLongestStep_s = 0.1F;

[[nodiscard]] bool held(char letter) { return ImGui::IsKeyDown(window::key_of_letter(letter)); }

[[nodiscard]] float axis(bool less, bool more) {
    return (more ? 1.0F : 0.0F) - (less ? 1.0F : 0.0F);
}

[[nodiscard]] Push of_keys() {
    Push push;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl || io.KeyAlt) return push;
    push.fly = {axis(held('a'), held('d')), axis(held('q'), held('e')), axis(held('s'), held('w'))};
    push.turn = {axis(ImGui::IsKeyDown(GLFW_KEY_LEFT), ImGui::IsKeyDown(GLFW_KEY_RIGHT)),
                 axis(ImGui::IsKeyDown(GLFW_KEY_DOWN), ImGui::IsKeyDown(GLFW_KEY_UP))};
    return push;
}

/// The first of the joysticks that GLFW has a mapping for.
[[nodiscard]] std::optional<GLFWgamepadstate> gamepad() {
    GLFWgamepadstate pad;
    for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
        if (glfwGetGamepadState(joystick, &pad) == GLFW_TRUE) return pad;
    }
    return std::nullopt;
}

[[nodiscard]] Push of_gamepad() {
    const auto pad = gamepad();
    return pad ? push_of_gamepad(std::span<const float, 6>(pad->axes)) : Push{};
}

void move(Desk& desk, const Push& push, float step_s) {
    Model& model = desk.model;
    renderer::Camera camera = model.view().camera;
    const glm::vec2 turn = kTurn_rad_s * step_s * push.turn;
    if (push.turn != glm::vec2(0.0F) && ImGui::GetIO().KeyShift) {
        const renderer::Camera from = upright(camera);
        camera = orbited(from, from.target_m, -turn.x, -turn.y);
    } else if (push.turn != glm::vec2(0.0F)) {
        camera = turned(camera, turn.x, turn.y);
    }
    if (push.fly != glm::vec3(0.0F)) {
        camera = flown(camera, desk.state.speed_m_s * step_s * push.fly);
    }
    model.look_from(camera, desk.now_s);
}

void next_camera(Desk& desk) {
    const auto cameras = desk.model.cameras();
    const auto now = std::find_if(cameras.begin(), cameras.end(), [&](const auto& one) {
        return same_view(one.camera, desk.model.view().camera);
    });
    const bool last = now == cameras.end() || now + 1 == cameras.end();
    desk.model.look_from(last ? cameras.front().name : (now + 1)->name, desk.now_s);
}

void change_layout(Desk& desk, Deed deed) {
    Layout layout = desk.model.layout();
    Pane& pane = layout.panes[static_cast<std::size_t>(desk.state.active_pane)];
    switch (deed) {
        case Deed::kNextArrangement:
            layout.arrangement = kArrangements[(static_cast<std::size_t>(layout.arrangement) + 1) %
                                               kArrangements.size()];
            break;
        case Deed::kOtherSide:
            pane.side = pane.side == 'a' ? 'b' : 'a';
            break;
        case Deed::kZoomIn:
            layout.zoom = next_zoom(layout.zoom, true, desk.state.whole_zoom);
            break;
        case Deed::kZoomOut:
            layout.zoom = next_zoom(layout.zoom, false, desk.state.whole_zoom);
            break;
        default:
            layout.zoom = 0.0F;
            layout.middle = glm::vec2(0.5F);
            desk.model.set_region(std::nullopt);
    }
    if (layout.arrangement != Arrangement::kFour) desk.state.active_pane = 0;
    desk.model.set_layout(layout, desk.now_s);
}

/// The window has the keys, and shows which of its fields they are for.
void show_where_keys_go(const char* window) {
    ImGui::SetWindowFocus(window);
    if (ImGuiWindow* found = ImGui::FindWindowByName(window)) ImGui::NavInitWindow(found, true);
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
}

void act(Desk& desk, Deed deed) {
    Model& model = desk.model;
    PanelState& state = desk.state;
    switch (deed) {
        case Deed::kHelp:
            state.help = !state.help;
            break;
        case Deed::kOpen:
            state.open_dialog = true;
            break;
        case Deed::kSaveImage:
            desk.orders.save_image = true;
            break;
        case Deed::kSaveBuffers:
            desk.orders.save_buffers = true;
            break;
        case Deed::kSaveToStudy:
            state.study_dialog_open = true;
            break;
        case Deed::kCopyCost:
            desk.orders.copy = cost_text(model, desk.device);
            break;
        case Deed::kUndo:
            model.undo(desk.now_s);
            break;
        case Deed::kRedo:
            model.redo(desk.now_s);
            break;
        case Deed::kBack:
            model.back(desk.now_s);
            break;
        case Deed::kForward:
            model.forward(desk.now_s);
            break;
        case Deed::kFrameAll:
            if (model.scene()) {
                model.look_from(
                    framing(model.view().camera, model.scene()->bounds(), model.aspect()),
                    desk.now_s);
            }
            break;
        case Deed::kNextCamera:
            if (model.scene()) next_camera(desk);
            break;
        case Deed::kNextPane:
            if (model.layout().arrangement == Arrangement::kFour) {
                state.active_pane = (state.active_pane + 1) % 4;
            }
            break;
        case Deed::kTimeAgain:
            model.time_again(9);
            break;
        case Deed::kPanels:
            state.panels = !state.panels;
            break;
        case Deed::kToPanels:
            state.panels = true;
            state.keys_in_panels = true;
            show_where_keys_go("##side");
            break;
        case Deed::kLargerText:
            state.text_scale = std::min(state.text_scale * 1.1F, 3.0F);
            break;
        case Deed::kSmallerText:
            state.text_scale = std::max(state.text_scale / 1.1F, 0.5F);
            break;
        case Deed::kFaster:
            state.speed_m_s = std::min(state.speed_m_s * 1.5F, 1e3F);
            break;
        case Deed::kSlower:
            state.speed_m_s = std::max(state.speed_m_s / 1.5F, 1e-3F);
            break;
        case Deed::kQuit:
            desk.orders.close = true;
            break;
        case Deed::kNextArrangement:
        case Deed::kOtherSide:
        case Deed::kZoomIn:
        case Deed::kZoomOut:
        case Deed::kWholeImage:
            change_layout(desk, deed);
    }
}

/// The digits choose what the active pane shows.
void digits(Desk& desk) {
    for (std::size_t i = 0; i < layer::kAll.size(); ++i) {
        const int key = GLFW_KEY_0 + static_cast<int>((i + 1) % 10);
        if (!ImGui::IsKeyPressed(key, false)) continue;
        Layout layout = desk.model.layout();
        layout.panes[static_cast<std::size_t>(desk.state.active_pane)].layer = layer::kAll[i];
        desk.model.set_layout(layout, desk.now_s);
    }
}

}  // namespace

bool has_gamepad() { return gamepad().has_value(); }

bool keyboard_and_gamepad(Desk& desk, double frame_s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (escape_pressed()) {
        if (!desk.opening.empty()) desk.orders.cancel_opening = true;
        ImGui::SetWindowFocus(nullptr);
        desk.state.help = false;
        desk.state.keys_in_panels = false;
    }
    const bool popup = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
    const bool in_panel = io.WantTextInput || popup || ImGui::IsAnyItemActive();
    if (in_panel) return false;
    const bool goes_through_panels = io.NavVisible || desk.state.keys_in_panels;
    for (const Key& key : keys()) {
        // Keys without a modifier are the panels' own while one is gone through by keyboard.
        if (!key.control && !key.alt && key.key < GLFW_KEY_F1 && goes_through_panels) {
            continue;
        }
        if (key.control != io.KeyCtrl || key.alt != io.KeyAlt) continue;
        const int code = key.letter != 0 ? window::key_of_letter(key.letter) : key.key;
        if (ImGui::IsKeyPressed(code, false)) act(desk, key.deed);
    }
    if (goes_through_panels) return false;
    if (!io.KeyCtrl && !io.KeyAlt) digits(desk);
    Push push = of_keys();
    const Push pad = of_gamepad();
    push.fly += pad.fly;
    push.turn += pad.turn;
    if (!push.any() || !desk.model.scene()) return false;
    move(desk, push, std::clamp(static_cast<float>(frame_s), 0.001F, kLongestStep_s));
    return true;
}

}  // namespace obscura::app::explorer
