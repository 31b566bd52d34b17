// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::app::window {

/// The key (GLFW_KEY_..., named by its place on a US keyboard) that types a letter from 'a' to 'z'
/// in the keyboard's layout of the moment: on a French one 'q' is GLFW_KEY_A. Where no key types
/// it, as in Cyrillic, the one at its place on a US keyboard. Needs GLFW.
[[nodiscard]] int key_of_letter(char letter);

}  // namespace obscura::app::window
