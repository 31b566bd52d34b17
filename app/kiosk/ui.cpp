// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/ui.h"

#include <imgui.h>
#include <imgui_internal.h>
// After Dear ImGui's own header.
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <limits>

#include "app/kiosk/clock.h"
#include "app/kiosk/stimulus_view.h"
#include "app/kiosk/widgets.h"
#include "renderer/base/error.h"

namespace obscura::app::kiosk {

Ui::Ui(Window& window, const std::vector<std::string>& texts, int grey_level)
    : window_(window), grey_level_(grey_level) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.UserData = &page_;
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    try {
        fonts_ = window::load_fonts(texts, window::sizes_of_pages(window.size().height));
    } catch (...) {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        throw;
    }
    set_style(fonts_.text->FontSize);
}

Ui::~Ui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Ui::begin_page() {
    page_ = {};
    ImGui::ClearActiveID();
    window_.input().open_at(std::numeric_limits<double>::infinity());
    window_.input().forget();
}

/// Dear ImGui sees no more of keyboard and mouse than the page may. Keys go to the page alone.
void Ui::hand_over_input() {
    ImGuiIO& io = ImGui::GetIO();
    Input& input = window_.input();
    page_.input = input.take_frame();
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
    for (const int button : page_.input.buttons) {
        if (button < IM_ARRAYSIZE(io.MouseDown)) io.MouseDown[button] = true;
    }
    if (page_.input.pointer) {
        io.MousePos = {static_cast<float>(page_.input.pointer->x),
                       static_cast<float>(page_.input.pointer->y)};
    }
    io.InputQueueCharacters.resize(0);
    if (!input.open(monotonic_s())) io.MouseWheel = 0.0F;
}

void Ui::draw(const std::function<void()>& page) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    hand_over_input();
    ImGui::NewFrame();
    page();
    ImGui::Render();
    draw_grey(window_.size(), grey_level_);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace obscura::app::kiosk
