// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/ui.h"

#include <imgui.h>
#include <imgui_internal.h>
// After Dear ImGui's own header.
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

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
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    try {
        fonts_ = load_fonts(texts, window.size().height);
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

void Ui::take_short_taps() {
    // Dear ImGui 1.86 reads which keys are down once a frame; one that went down and up between
    // two frames is shown to it as down for a frame.
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : tapped_) {
        io.KeysDown[key] = glfwGetKey(window_.handle(), key) == GLFW_PRESS;
    }
    tapped_ = window_.take_taps();
    for (const int key : tapped_) io.KeysDown[key] = true;
}

void Ui::draw(const std::function<void()>& page) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    take_short_taps();
    ImGui::NewFrame();
    page();
    ImGui::Render();
    draw_grey(window_.size(), grey_level_);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Ui::forget_input() { ImGui::ClearActiveID(); }

}  // namespace obscura::app::kiosk
