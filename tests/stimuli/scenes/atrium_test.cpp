// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "renderer/base/hash.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::stimuli {
namespace {

using renderer::Mesh;
using renderer::Scene;
using renderer::Vertex;

const BuiltinScene& atrium() {
    const BuiltinScene* scene = find_builtin_scene("atrium");
    if (scene == nullptr) throw std::runtime_error("no built-in scene \"atrium\"");
    return *scene;
}

/// Every byte that the renderer reads of a scene's geometry and textures.
std::string digest(const Scene& scene) {
    std::string bytes;
    const auto add = [&bytes](const auto* data, std::size_t count) {
        bytes.append(reinterpret_cast<const char*>(data), count * sizeof(*data));
    };
    for (const Mesh& mesh : scene.meshes) {
        for (const Vertex& vertex : mesh.vertices) {
            add(&vertex.position_m, 1);
            add(&vertex.normal, 1);
            add(&vertex.tangent, 1);
            add(&vertex.uv, 1);
            add(&vertex.color, 1);
        }
        add(mesh.indices.data(), mesh.indices.size());
        add(&mesh.material, 1);
    }
    for (const renderer::Texture& texture : scene.textures) {
        add(texture.rgba.data(), texture.rgba.size());
    }
    return base::sha256_hex(bytes);
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Distance along a ray to a triangle (Moeller and Trumbore 1997), infinity where it misses.
float distance_to(const glm::vec3& from, const glm::vec3& along, const glm::vec3& a,
                  const glm::vec3& b, const glm::vec3& c) {
    const float miss = std::numeric_limits<float>::infinity();
    const glm::vec3 p = glm::cross(along, c - a);
    const float determinant = glm::dot(b - a, p);
    if (std::abs(determinant) < 1e-12F) return miss;
    const glm::vec3 offset = from - a;
    const float u = glm::dot(offset, p) / determinant;
    const glm::vec3 q = glm::cross(offset, b - a);
    const float v = glm::dot(along, q) / determinant;
    if (u < 0.0F || v < 0.0F || u + v > 1.0F) return miss;
    const float distance = glm::dot(c - a, q) / determinant;
    return distance > 0.0F ? distance : miss;
}

void expect_sound_vertices(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        std::size_t bad = 0;
        for (const Vertex& vertex : mesh.vertices) {
            const glm::vec3 tangent(vertex.tangent);
            const bool good = finite(vertex.position_m) && std::isfinite(vertex.uv.x) &&
                              std::isfinite(vertex.uv.y) &&
                              std::abs(glm::length(vertex.normal) - 1.0F) < 1e-3F &&
                              std::abs(glm::length(tangent) - 1.0F) < 1e-3F &&
                              std::abs(glm::dot(tangent, vertex.normal)) < 1e-2F &&
                              std::abs(vertex.tangent.w) == 1.0F;
            if (!good) ++bad;
        }
        EXPECT_EQ(bad, 0U) << mesh.name << " of " << mesh.vertices.size();
    }
}

void expect_sound_triangles(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_FALSE(mesh.indices.empty()) << mesh.name;
        ASSERT_EQ(mesh.indices.size() % 3, 0U) << mesh.name;
        ASSERT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()),
                  mesh.vertices.size());
        std::size_t against = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vertex& a = mesh.vertices[mesh.indices[i]];
            const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
            const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
            const glm::vec3 area =
                glm::cross(b.position_m - a.position_m, c.position_m - a.position_m);
            if (glm::dot(area, a.normal + b.normal + c.normal) < 0.0F) ++against;
        }
        // A few slivers at the tips of leaves and folds may turn over.
        EXPECT_LE(against, mesh.indices.size() / 3 / 200) << mesh.name;
    }
}

void expect_valid_materials(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) ASSERT_LT(mesh.material, scene.materials.size());
    const auto count = static_cast<renderer::TextureIndex>(scene.textures.size());
    for (const renderer::Material& material : scene.materials) {
        ASSERT_GE(material.albedo_texture, 0) << material.name;
        ASSERT_LT(material.albedo_texture, count) << material.name;
        ASSERT_GE(material.normal_texture, 0) << material.name;
        ASSERT_LT(material.normal_texture, count) << material.name;
        EXPECT_TRUE(scene.textures[static_cast<std::size_t>(material.albedo_texture)].srgb);
        EXPECT_FALSE(scene.textures[static_cast<std::size_t>(material.normal_texture)].srgb);
        EXPECT_GE(material.specular_power, 1.0F);
        EXPECT_LE(material.specular_power, 255.0F);
        EXPECT_LE(material.specular_intensity, 1.0F);
    }
    for (const renderer::Texture& texture : scene.textures) {
        EXPECT_EQ(texture.rgba.size(), 4U * static_cast<std::size_t>(texture.width) *
                                           static_cast<std::size_t>(texture.height))
            << texture.name;
    }
}

void expect_cameras_in_the_open(const Scene& scene) {
    for (const std::string& name : atrium().cameras) {
        const renderer::Camera* camera = scene.find_camera(name);
        ASSERT_NE(camera, nullptr) << name;
        const glm::vec3 forward = glm::normalize(camera->target_m - camera->position_m);
        const glm::vec3 right = glm::normalize(glm::cross(forward, camera->up));
        const glm::vec3 up = glm::cross(right, forward);
        const float scale = std::tan(0.5F * camera->vertical_fov_rad);
        for (const glm::vec2 place :
             {glm::vec2(0.0F), glm::vec2(-1.6F, 0.8F), glm::vec2(1.6F, 0.8F),
              glm::vec2(-1.6F, -0.8F), glm::vec2(1.6F, -0.8F)}) {
            const glm::vec3 along =
                glm::normalize(forward + scale * (right * place.x + up * place.y));
            float nearest = std::numeric_limits<float>::infinity();
            bool front = true;
            for (const Mesh& mesh : scene.meshes) {
                for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                    const glm::vec3& a = mesh.vertices[mesh.indices[i]].position_m;
                    const glm::vec3& b = mesh.vertices[mesh.indices[i + 1]].position_m;
                    const glm::vec3& c = mesh.vertices[mesh.indices[i + 2]].position_m;
                    const float distance = distance_to(camera->position_m, along, a, b, c);
                    if (distance >= nearest) continue;
                    nearest = distance;
                    front = scene.materials[mesh.material].double_sided ||
                            glm::dot(glm::cross(b - a, c - a), along) < 0.0F;
                }
            }
            EXPECT_GT(nearest, 0.5F) << name << ": something hangs before the lens";
            EXPECT_TRUE(front) << name << " sees the inside of something";
            EXPECT_TRUE(nearest < camera->far_m || !std::isfinite(nearest)) << name;
        }
    }
}

// One test for all that is seen in one built scene, because building it takes a second.
TEST(Atrium, IsSoundAndTheSameInEveryRun) {
    const Scene scene = atrium().build();
    EXPECT_GE(scene.triangle_count(), 400000U);
    EXPECT_LE(scene.triangle_count(), 800000U);
    expect_sound_vertices(scene);
    expect_sound_triangles(scene);
    expect_valid_materials(scene);
    expect_cameras_in_the_open(scene);
    EXPECT_EQ(digest(scene), digest(atrium().build()));
}

TEST(Atrium, PlantsHaveLeavesThatAreCutOut) {
    const Scene scene = atrium().build();
    std::size_t leaves = 0;
    for (const Mesh& mesh : scene.meshes) {
        const renderer::Material& material = scene.materials[mesh.material];
        if (material.coverage == renderer::Coverage::kCutOut) leaves += mesh.indices.size() / 3;
    }
    EXPECT_GT(leaves, 20'000U);
}

TEST(Atrium, EachLevelAddsLightToTheOneBefore) {
    const renderer::Lighting moderate = atrium().lighting(Validity::kModerate);
    const renderer::Lighting high = atrium().lighting(Validity::kHigh);
    ASSERT_NE(moderate.environment, nullptr);
    ASSERT_NE(high.environment, nullptr);
    EXPECT_EQ(moderate.environment->radiance, high.environment->radiance);
    EXPECT_TRUE(moderate.lights.empty());
    EXPECT_TRUE(moderate.irradiance_probes && high.irradiance_probes);
    ASSERT_EQ(high.lights.size(), 1U);
    EXPECT_NEAR(glm::length(high.lights[0].towards_light), 1.0F, 1e-5F);
    EXPECT_TRUE(high.tone_mapping.has_value());
    EXPECT_TRUE(high.normal_mapping);
}

}  // namespace
}  // namespace obscura::stimuli
