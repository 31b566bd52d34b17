// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/window/glfw.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string>

namespace obscura::app::window {
namespace {

[[nodiscard]] std::string glfw_reason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

[[nodiscard]] std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? fmt::format("{} is {}", name, value)
                            : fmt::format("{} is not set", name);
}

}  // namespace

void start_glfw(std::string_view who) {
    if (glfwInit() == GLFW_TRUE) return;
    throw base::failure("no display: {} ({}, {}); {} needs a screen", glfw_reason(),
                        variable("DISPLAY"), variable("WAYLAND_DISPLAY"), who);
}

void ask_for_context() {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RED_BITS, 8);
    glfwWindowHint(GLFW_GREEN_BITS, 8);
    glfwWindowHint(GLFW_BLUE_BITS, 8);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SAMPLES, 0);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
}

base::Error no_context() {
    return base::failure(
        "no OpenGL 4.5 core context in a window: {}; the driver is missing or too old "
        "(Mesa's is in the package libgl1-mesa-dri)",
        glfw_reason());
}

}  // namespace obscura::app::window
