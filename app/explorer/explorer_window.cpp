// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/explorer_window.h"

#include <epoxy/gl.h>
#include <imgui.h>
// After epoxy, which brings the OpenGL declarations, and Dear ImGui's own header.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/explorer/look.h"
#include "app/window/glfw.h"

namespace obscura::app::explorer {
namespace {

constexpr float kText_px = 15.0F;
constexpr float kHeading_px = 19.0F;
constexpr float kSmall_px = 13.0F;
/// A screen with more rows than this is held for one of small pixels, even if it does not say so.
constexpr float kRowsOfUsualScreen = 1250.0F;
constexpr WindowSize kUsual{1600, 900};  ///< on a screen of usual pixels

}  // namespace

struct ExplorerWindow::Callbacks {
    [[nodiscard]] static ExplorerWindow& of(GLFWwindow* window) {
        return *static_cast<ExplorerWindow*>(glfwGetWindowUserPointer(window));
    }
    static void note_input(GLFWwindow* window) {
        ExplorerWindow& self = of(window);
        if (!self.first_input_s_) self.first_input_s_ = now_s();
    }
    static void key(GLFWwindow* window, int key, int, int action, int modifiers) {
        note_input(window);
        of(window).pressed_ |= action == GLFW_PRESS;
        if (action == GLFW_PRESS && key >= 0 && key < IM_ARRAYSIZE(ImGuiIO::KeysDown)) {
            of(window).presses_.push_back({key, modifiers});
        }
    }
    static void pointer(GLFWwindow* window, double, double) { note_input(window); }
    static void button(GLFWwindow* window, int, int action, int) {
        note_input(window);
        of(window).pressed_ |= action == GLFW_PRESS;
        // Without a window manager a click alone brings no window to the keys.
        if (action == GLFW_PRESS && glfwGetWindowAttrib(window, GLFW_FOCUSED) != GLFW_TRUE) {
            glfwFocusWindow(window);
        }
    }
    static void wheel(GLFWwindow* window, double, double) { note_input(window); }
    static void dropped(GLFWwindow* window, int count, const char** paths) {
        for (int i = 0; i < count; ++i) of(window).dropped_.emplace_back(paths[i]);
    }
};

ExplorerWindow::ExplorerWindow(const std::optional<WindowSize>& size) {
    window::start_glfw("the explorer");
    window::ask_for_context();
    glfwWindowHint(GLFW_RESIZABLE, GLFW_TRUE);
    // A driver that was reset says so, where it can.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    const float scale = screen_scale();
    WindowSize wanted = size.value_or(WindowSize{static_cast<int>(scale * kUsual.width),
                                                 static_cast<int>(scale * kUsual.height)});
    int left = 0;
    int top = 0;
    WindowSize room = wanted;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        glfwGetMonitorWorkarea(monitor, &left, &top, &room.width, &room.height);
    }
    wanted.width = std::clamp(wanted.width, 1, std::max(1, room.width));
    wanted.height = std::clamp(wanted.height, 1, std::max(1, room.height));
    window_ = glfwCreateWindow(wanted.width, wanted.height, "Obscura", nullptr, nullptr);
    if (window_ == nullptr) {
        const base::Error error = window::no_context();
        glfwTerminate();
        throw error;
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, &Callbacks::key);
    glfwSetCursorPosCallback(window_, &Callbacks::pointer);
    glfwSetMouseButtonCallback(window_, &Callbacks::button);
    glfwSetScrollCallback(window_, &Callbacks::wheel);
    glfwSetDropCallback(window_, &Callbacks::dropped);
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    // Calls the callbacks from above, too.
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    try {
        load_fonts();
    } catch (...) {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        glfwDestroyWindow(window_);
        glfwTerminate();
        throw;
    }
    kept_panel_ = std::make_unique<KeptPanel>();
    glfwFocusWindow(window_);
}

ExplorerWindow::~ExplorerWindow() {
    kept_panel_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

float ExplorerWindow::screen_scale() const {
    float across = 1.0F;
    float down = 1.0F;
    float rows = 0.0F;
    if (window_ != nullptr) glfwGetWindowContentScale(window_, &across, &down);
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        if (window_ == nullptr) glfwGetMonitorContentScale(monitor, &across, &down);
        if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) {
            rows = static_cast<float>(mode->height);
        }
    }
    const float scale = std::max({across, down, rows / kRowsOfUsualScreen});
    return std::isfinite(scale) ? std::clamp(scale, 1.0F, 4.0F) : 1.0F;
}

void ExplorerWindow::load_fonts() {
    screen_scale_ = screen_scale();
    text_scale_ = std::clamp(wanted_text_scale_, 0.5F, 3.0F);
    wanted_text_scale_ = text_scale_;
    const float scale = screen_scale_ * text_scale_;
    ImGui::GetIO().Fonts->Clear();
    fonts_ = window::load_fonts({}, {std::round(kText_px * scale), std::round(kHeading_px * scale),
                                     std::round(kSmall_px * scale)});
    set_look(fonts_.text->FontSize);
}

WindowSize ExplorerWindow::size() const {
    WindowSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
}

bool ExplorerWindow::wants_to_close() const { return glfwWindowShouldClose(window_) != 0; }

void ExplorerWindow::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void ExplorerWindow::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void ExplorerWindow::begin_frame(double wait_s, double not_before_s,
                                 const std::function<bool()>& at_once) {
    if (wait_s > 0.0) {
        glfwWaitEventsTimeout(wait_s);
    } else {
        glfwPollEvents();
    }
    while (now_s() < not_before_s && !(at_once && at_once())) {
        glfwWaitEventsTimeout(std::max(1e-3, not_before_s - now_s()));
    }
    if (wanted_text_scale_ != text_scale_ || screen_scale() != screen_scale_) {
        load_fonts();
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    show_short_presses();
    ImGui::NewFrame();
}

void ExplorerWindow::show_short_presses() {
    // Dear ImGui sees only what is down when a frame begins, and frames may be slow.
    ImGuiIO& io = ImGui::GetIO();
    const auto down = [&io](int left, int right) {
        return io.KeysDown[left] || io.KeysDown[right];
    };
    const auto set_modifiers = [&](int more) {
        io.KeyCtrl =
            down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) || (more & GLFW_MOD_CONTROL) != 0;
        io.KeyShift =
            down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT) || (more & GLFW_MOD_SHIFT) != 0;
        io.KeyAlt = down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT) || (more & GLFW_MOD_ALT) != 0;
    };
    const bool had = !shown_.empty();
    for (const int key : std::exchange(shown_, {})) io.KeysDown[key] = false;
    if (had) set_modifiers(0);
    int modifiers = 0;
    for (const Press& press : std::exchange(presses_, {})) {
        if (io.KeysDown[press.key]) continue;
        io.KeysDown[press.key] = true;
        shown_.push_back(press.key);
        modifiers |= press.modifiers;
    }
    if (!shown_.empty()) set_modifiers(modifiers);
}

void ExplorerWindow::end_frame(const std::optional<PanelPlace>& kept) {
    ImGui::Render();
    if (kept) {
        kept_panel_->put_picture(*ImGui::GetDrawData(), *kept, now_s());
    } else {
        kept_panel_->forget();
    }
    const WindowSize now = size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, now.width, now.height);
    glClearColor(0.16F, 0.17F, 0.18F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
    first_input_s_.reset();
    pressed_ = false;
}

bool ExplorerWindow::is_lost() const {
    return told_lost_ || glGetGraphicsResetStatus() != GL_NO_ERROR;
}

void ExplorerWindow::wake() { glfwPostEmptyEvent(); }

std::vector<std::string> ExplorerWindow::take_dropped() { return std::exchange(dropped_, {}); }

double ExplorerWindow::now_s() { return glfwGetTime(); }

}  // namespace obscura::app::explorer
