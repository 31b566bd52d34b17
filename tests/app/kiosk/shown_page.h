// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/kiosk/screens.h"
#include "app/kiosk/stage.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/app/kiosk/virtual_display.h"

namespace obscura::app::kiosk {

using Draw = std::function<std::optional<Event>()>;

inline std::string many_lines(int count) {
    std::string text;
    for (int i = 1; i <= count; ++i) {
        text +=
            fmt::format("{}. A sentence that each participant is to read before the start.\n\n", i);
    }
    return text;
}

/// One page in a window, from its first frame on.
class ShownPage {
  public:
    ShownPage(Window& window, Ui& ui, Draw draw)
        : window_(window), ui_(ui), draw_(std::move(draw)) {
        draw_first_frame(ui_, [this] { event_ = draw_(); });
        window_.present();
        window_.poll_events();
        window_.input().forget();
        window_.input().open_at(0.0);
    }
    /// Frames until all input is used up and the layout follows it.
    void draw() {
        for (int frame = 0; frame < 6 || window_.input().more(); ++frame) {
            ui_.draw([this] {
                auto event = draw_();
                if (event) event_ = event;
            });
        }
        window_.present();
    }
    void press(int key, int modifiers = 0) {
        window_.input().key_down({key, modifiers, ++time_s_});
        if (key == GLFW_KEY_SPACE) window_.input().types(U' ');
        draw();
    }
    void type(const std::u32string& text) {
        for (const char32_t character : text) {
            window_.input().key_down({GLFW_KEY_A, 0, ++time_s_});
            window_.input().types(character);
        }
        draw();
    }
    void scroll(float lines) {
        ImGui::GetIO().MouseWheel += lines;
        draw();
    }
    /// The mouse's left button at a place, the pointer then moved on before a frame is drawn.
    void click(PointerPlace at, PointerPlace moved_on) {
        window_.input().pointer_moves(at);
        window_.input().button_down(GLFW_MOUSE_BUTTON_LEFT, ++time_s_);
        window_.input().button_up(GLFW_MOUSE_BUTTON_LEFT, ++time_s_);
        window_.input().pointer_moves(moved_on);
        draw();
    }
    /// The middle of a text in the window as it was drawn last; nothing: it is not there.
    [[nodiscard]] static std::optional<PointerPlace> place_of(const std::string& text) {
        for (const Typesetter::Use& use : page_state().tools.typesetter->uses()) {
            if (use.text != text || use.texture == 0) continue;
            if (const auto place = place_of(use.texture)) return place;
        }
        return std::nullopt;
    }
    void click_on(const std::string& text) {
        const auto place = place_of(text);
        ASSERT_TRUE(place.has_value()) << text << " is not there";
        click(*place, *place);
    }
    /// What was pressed since the last call.
    [[nodiscard]] std::optional<Event> event() { return std::exchange(event_, std::nullopt); }
    [[nodiscard]] static float scrolled() { return page_state().scrolled_px; }
    [[nodiscard]] static bool end_seen() { return page_state().end_seen; }

  private:
    [[nodiscard]] static std::optional<PointerPlace> place_of(unsigned texture) {
        const auto id = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture));
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i) {
            const ImDrawList& list = *data.CmdLists[i];
            for (const ImDrawCmd& command : list.CmdBuffer) {
                if (command.TextureId != id) continue;
                ImRect box(1e9F, 1e9F, -1e9F, -1e9F);
                for (unsigned at = 0; at < command.ElemCount; ++at) {
                    const auto index = static_cast<int>(command.IdxOffset + at);
                    box.Add(
                        list.VtxBuffer[list.IdxBuffer[index] + static_cast<int>(command.VtxOffset)]
                            .pos);
                }
                return PointerPlace{box.GetCenter().x, box.GetCenter().y};
            }
        }
        return std::nullopt;
    }

    Window& window_;
    Ui& ui_;
    Draw draw_;
    std::optional<Event> event_;
    double time_s_ = 0.0;
};

class Pages : public testing::Test {
  protected:
    explicit Pages(Extent size = {1024, 720})
        : display_(size.width, size.height),
          window_({0, false, {64, 64}}),
          ui_(window_, study_.words, 128) {
        study_.instructions = many_lines(60);
    }
    [[nodiscard]] ShownPage show(Draw draw) { return {window_, ui_, std::move(draw)}; }
    [[nodiscard]] ShownPage show_instructions() {
        return show([this] { return instructions_screen(ui_.fonts(), study_); });
    }
    [[nodiscard]] ShownPage show_form() {
        return show([this] { return form_screen(ui_.fonts(), study_, form_); });
    }

    stimuli::Study study_ = small_study(3);
    VirtualDisplay display_;
    Window window_;
    Ui ui_;
    FormDraft form_;
};

}  // namespace obscura::app::kiosk
