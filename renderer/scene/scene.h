// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace obscura::renderer {

/// One corner of a triangle. World space, metres, right-handed, Y up.
struct Vertex {
    glm::vec3 position_m{0.0F};
    glm::vec3 normal{0.0F, 1.0F, 0.0F};         ///< unit length, outwards
    glm::vec4 tangent{1.0F, 0.0F, 0.0F, 1.0F};  ///< unit length along +u; w = handedness, +1 or -1
    glm::vec2 uv{0.0F};                         ///< v = 0 is the first row of the texture
    glm::u8vec4 color{255, 255, 255, 255};      ///< linear factor of the albedo, 255 = 1
};

/// 8-bit RGBA texels, first row first, wrapped in both directions.
struct Texture {
    std::string name;
    int width = 0;
    int height = 0;
    bool srgb = true;                ///< colour: decoded to linear when sampled; normals: false
    std::vector<std::uint8_t> rgba;  ///< 4 * width * height bytes
};

/// Index into Scene::textures, or none.
using TextureIndex = std::int32_t;
inline constexpr TextureIndex kNoTexture = -1;

/// What the alpha of a surface (of its albedo texture and its `opacity`) means.
enum class Coverage {
    kOpaque,   ///< nothing
    kCutOut,   ///< below alpha_cutoff there is no surface, for eyes, shadows and occlusion alike
    kBlended,  ///< mixed over what lies behind
};

/// A surface as the G-buffer stores it (Jakobsen 2010, Table 1).
struct Material {
    std::string name;
    glm::vec3 albedo{1.0F};           ///< linear factor of the texture, [0, 1]
    float specular_intensity = 0.0F;  ///< [0, 1]
    float specular_power = 16.0F;     ///< Blinn-Phong exponent, [1, 255]; of a roughness texture
                                      ///< where there is one
    TextureIndex albedo_texture = kNoTexture;
    TextureIndex normal_texture = kNoTexture;     ///< tangent space, +Y towards +v, 128 = 0
    TextureIndex roughness_texture = kNoTexture;  ///< green: roughness, blue: metalness (glTF 2.0)
    float roughness = 1.0F;                       ///< factor of the texture's, [0, 1]
    float metalness = 0.0F;  ///< the same; a metal's intensity is its albedo's luminance times
                             ///< (1 - roughness)
    bool double_sided = false;
    Coverage coverage = Coverage::kOpaque;
    float opacity = 1.0F;                         ///< factor of the texture's alpha, [0, 1]
    float alpha_cutoff = 0.5F;                    ///< [0, 1]
    glm::vec3 emissive{0.0F};                     ///< linear radiance it sends out by itself, >= 0
    TextureIndex emissive_texture = kNoTexture;   ///< factor of `emissive`
    TextureIndex occlusion_texture = kNoTexture;  ///< baked accessibility in its red channel
    float occlusion_strength = 1.0F;              ///< 0: the texture does nothing, 1: all of it
};

/// Triangles of one material: three indices each, counter-clockwise seen from outside.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::uint32_t material = 0;  ///< index into Scene::materials
};

/// A pinhole camera that looks from `position_m` to `target_m`; `up` need not be perpendicular.
struct Camera {
    std::string name;
    glm::vec3 position_m{0.0F, 0.0F, 1.0F};
    glm::vec3 target_m{0.0F};
    glm::vec3 up{0.0F, 1.0F, 0.0F};
    float vertical_fov_rad = 0.8F;  ///< (0, pi)
    float near_m = 0.05F;           ///< > 0
    float far_m = 100.0F;           ///< > near_m; also what `crytek` divides depth by
    glm::vec2 lens_shift{0.0F};  ///< off-centre frustum: where the view axis is not, in half widths
                                 ///< and heights of the image; (1, 0) puts it on the left border
};

/// Geometry, surfaces and views. Light is not part of it: the same scene serves several levels.
struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Camera> cameras;

    [[nodiscard]] std::size_t triangle_count() const {
        std::size_t count = 0;
        for (const Mesh& mesh : meshes) count += mesh.indices.size() / 3;
        return count;
    }

    /// The camera of that name, or nullptr.
    [[nodiscard]] const Camera* find_camera(const std::string& camera_name) const {
        for (const Camera& camera : cameras) {
            if (camera.name == camera_name) return &camera;
        }
        return nullptr;
    }
};

}  // namespace obscura::renderer
