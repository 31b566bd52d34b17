// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// The texels as the bytes of a PNG file: RGB where all of them are opaque, else RGBA with alpha
/// not multiplied in. Throws failure where the image library does.
[[nodiscard]] std::string encode_rgba_png(const Texture& texture);

}  // namespace obscura::renderer
