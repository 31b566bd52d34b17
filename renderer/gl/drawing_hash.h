// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::renderer {

/// SHA-256 of all that decides how a scene is drawn, beside the scene: this program, the driver
/// and, where they are read from a folder, the shaders. Needs a current OpenGL context.
[[nodiscard]] std::string drawing_sha256();

}  // namespace obscura::renderer
