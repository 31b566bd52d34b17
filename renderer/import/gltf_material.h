// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "renderer/import/files_read.h"
#include "renderer/import/gltf_check.h"
#include "renderer/import/image.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer::import_detail {

/// How a material's textures lie on a mesh: a set of texture coordinates, moved, turned and scaled
/// (KHR_texture_transform).
struct UvMapping {
    int set = 0;
    glm::dvec2 offset{0.0};
    glm::dvec2 scale{1.0};
    double rotation_rad = 0.0;

    bool operator==(const UvMapping&) const = default;
    [[nodiscard]] glm::vec2 apply(const glm::vec2& uv) const;
};

/// Reads a document's materials into a scene, with the textures they use.
///
/// Metallic-roughness surfaces become what the G-buffer holds: the albedo is the base colour, the
/// power follows from the roughness and the specular intensity from the index of refraction and
/// KHR_materials_specular (renderer/scene/surface_conversion.h), texel by texel where there is a
/// texture. There are no reflections of the
/// surroundings, so a metal keeps its base colour as albedo, which is what it reflects in even
/// light, and a highlight of base colour times (1 - roughness).
class GltfMaterials {
  public:
    GltfMaterials(const GltfFile& file, FilesRead& files, Notes& notes, Scene& scene);

    /// Reads all of them; one more, glTF's standard material, follows the last when asked for.
    void read();
    /// Index in the scene of glTF's standard material.
    [[nodiscard]] std::uint32_t standard();
    [[nodiscard]] const Material& material(std::uint32_t index) const {
        return scene_.materials[index];
    }
    /// How the textures of the scene's material lie.
    [[nodiscard]] const UvMapping& mapping(std::uint32_t material) const {
        return mappings_[material];
    }

  private:
    struct Use {
        JsonCursor info;  ///< a textureInfo
        std::size_t texture = 0;
        UvMapping mapping;
    };
    struct Surface;

    [[nodiscard]] Surface read_surface(const JsonCursor& cursor, const std::string& name);
    /// Adds the surface's material to the scene, with its texture of roughness.
    void add(Surface& surface);
    [[nodiscard]] std::optional<Use> find_use(const std::optional<JsonCursor>& owner,
                                              const char* key) const;
    void read_metallic_roughness(const JsonCursor& cursor, Surface& surface);
    void read_specular_glossiness(const JsonCursor& extension, Surface& surface);
    void read_extensions(const JsonCursor& cursor, Surface& surface);
    void read_coverage(const JsonCursor& cursor, Material& material);
    void read_textures(const JsonCursor& cursor, Surface& surface);
    void read_roughness(Surface& surface);
    /// Whether the texture lies as the material's others do; notes it where it does not.
    bool lies_alike(const std::optional<Use>& use, Surface& surface, const char* what);

    [[nodiscard]] std::optional<std::size_t> image_of(const Use& use);
    [[nodiscard]] std::string name_of_image(std::size_t image) const;
    /// The decoded image, or nothing and why.
    [[nodiscard]] std::optional<Texture> decode(std::size_t image, bool srgb, std::string& why);
    /// Index of the texture in the scene; kNoTexture, with a note, where it cannot be read.
    [[nodiscard]] TextureIndex texture(const Use& use, bool srgb, double normal_scale,
                                       const char* instead);
    /// Of all texels, [0, 1]; 1 where there are none that can be read.
    [[nodiscard]] glm::vec3 mean_of(const Use& use);

    const GltfFile& file_;
    FilesRead& files_;
    Notes& notes_;
    Scene& scene_;
    ImageDecoder decoder_;
    std::vector<UvMapping> mappings_;
    std::optional<std::uint32_t> standard_;
    std::map<std::tuple<std::size_t, bool, double>, TextureIndex> textures_;
    std::map<std::size_t, glm::vec3> means_;  ///< by image
};

}  // namespace obscura::renderer::import_detail
