// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// What every reader of a scene rests on. Each throws bad input that names the scene, the mesh,
/// material or texture, and the value: an index that leads to nothing, or a texture whose bytes are
/// not four a texel.
void check_mesh(const Scene& scene, const Mesh& mesh);
void check_textures(const Scene& scene, const Material& material);
void check_texture(const Scene& scene, const Texture& texture);

/// The textures of a material, used or not (kNoTexture).
[[nodiscard]] std::array<TextureIndex, 5> textures_of(const Material& material);

}  // namespace obscura::renderer
