// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/scene/scene_check.h"

#include "renderer/base/error.h"

namespace obscura::renderer {

void check_mesh(const Scene& scene, const Mesh& mesh) {
    if (mesh.material >= scene.materials.size()) {
        throw base::bad_input("scene {}, mesh {}: material {} of {}", scene.name, mesh.name,
                              mesh.material, scene.materials.size());
    }
    for (const std::uint32_t index : mesh.indices) {
        if (index >= mesh.vertices.size()) {
            throw base::bad_input("scene {}, mesh {}: index {} of {} vertices", scene.name,
                                  mesh.name, index, mesh.vertices.size());
        }
    }
}

void check_textures(const Scene& scene, const Material& material) {
    const auto count = static_cast<TextureIndex>(scene.textures.size());
    for (const TextureIndex index : textures_of(material)) {
        if (index < kNoTexture || index >= count) {
            throw base::bad_input("scene {}, material {}: texture {} of {}", scene.name,
                                  material.name, index, count);
        }
    }
}

void check_texture(const Scene& scene, const Texture& texture) {
    const auto texels =
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    if (texture.width < 1 || texture.height < 1 || texture.rgba.size() != 4 * texels) {
        throw base::bad_input("scene {}, texture {}: {} bytes for {}x{} texels", scene.name,
                              texture.name, texture.rgba.size(), texture.width, texture.height);
    }
}

std::array<TextureIndex, 5> textures_of(const Material& material) {
    return {material.albedo_texture, material.normal_texture, material.roughness_texture,
            material.emissive_texture, material.occlusion_texture};
}

}  // namespace obscura::renderer
