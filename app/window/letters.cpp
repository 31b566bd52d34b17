// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/window/letters.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string_view>

namespace obscura::app::window {

int key_of_letter(char letter) {
    const std::string_view wanted(&letter, 1);
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_WORLD_2; ++key) {
        const char* name = glfwGetKeyName(key, 0);
        if (name != nullptr && name == wanted) return key;
    }
    return GLFW_KEY_A + (letter - 'a');
}

}  // namespace obscura::app::window
