// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/scenes/list.h"
#include "tests/stimuli/scenes/mesh_soundness.h"

namespace obscura::stimuli {
namespace {

using renderer::Mesh;
using renderer::Scene;
using renderer::Vertex;

/// Along the edges of triangles, the largest number of repeats of the texture in a metre.
float densest_texture(const Mesh& mesh) {
    float densest = 0.0F;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
        const float apart_m = glm::distance(a.position_m, b.position_m);
        if (apart_m > 1e-6F) densest = std::max(densest, glm::distance(a.uv, b.uv) / apart_m);
    }
    return densest;
}

/// How many vertices lie before the camera and within its frame of 16 : 9.
std::size_t seen_by(const renderer::Camera& camera, const Scene& scene) {
    const glm::vec3 forward = glm::normalize(camera.target_m - camera.position_m);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    const float half = std::tan(0.5F * camera.vertical_fov_rad);
    std::size_t seen = 0;
    for (const Mesh& mesh : scene.meshes) {
        for (const Vertex& vertex : mesh.vertices) {
            const glm::vec3 way = vertex.position_m - camera.position_m;
            const float depth = glm::dot(way, forward);
            if (depth > camera.near_m && depth < camera.far_m &&
                std::abs(glm::dot(way, up)) < half * depth &&
                std::abs(glm::dot(way, right)) < 16.0F / 9.0F * half * depth) {
                ++seen;
            }
        }
    }
    return seen;
}

void expect_believable(const BuiltinScene& entry, const Scene& scene) {
    EXPECT_GE(scene.triangle_count(), 150'000U);
    EXPECT_LE(scene.triangle_count(), 900'000U);
    for (const Mesh& mesh : scene.meshes) {
        expect_sound(mesh);
        ASSERT_LT(mesh.material, scene.materials.size()) << mesh.name;
        EXPECT_LT(densest_texture(mesh), 1000.0F) << mesh.name << " has a crushed texture";
    }
    for (const renderer::Material& material : scene.materials) {
        ASSERT_GE(material.albedo_texture, 0) << material.name;
        const auto& texture = scene.textures[static_cast<std::size_t>(material.albedo_texture)];
        bool holes = false;
        for (std::size_t i = 3; i < texture.rgba.size(); i += 4) {
            holes = holes || texture.rgba[i] < 128;
        }
        EXPECT_EQ(holes, material.coverage == renderer::Coverage::kCutOut) << material.name;
    }
    ASSERT_GE(entry.cameras.size(), 2U);
    ASSERT_EQ(scene.cameras.size(), entry.cameras.size());
    for (const std::string& name : entry.cameras) {
        const renderer::Camera* camera = scene.find_camera(name);
        ASSERT_NE(camera, nullptr) << name;
        EXPECT_GT(camera->position_m.y, 1.2F) << name << " is not at a person's eye";
        EXPECT_LT(camera->position_m.y, 1.8F) << name << " is not at a person's eye";
        EXPECT_GT(seen_by(*camera, scene), 20'000U) << name;
        for (const Mesh& mesh : scene.meshes) {
            for (const Vertex& vertex : mesh.vertices) {
                ASSERT_GT(glm::distance(vertex.position_m, camera->position_m),
                          2.0F * camera->near_m)
                    << name << " touches " << mesh.name;
            }
        }
    }
}

void expect_same_in_every_build(const BuiltinScene& entry) {
    const Scene scene = entry.build();
    expect_believable(entry, scene);
    const Scene again = entry.build();
    ASSERT_EQ(scene.meshes.size(), again.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        EXPECT_TRUE(same_mesh(scene.meshes[i], again.meshes[i])) << scene.meshes[i].name;
    }
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        EXPECT_EQ(scene.textures[i].rgba, again.textures[i].rgba) << scene.textures[i].name;
    }
}

TEST(Machine, IsSoundDetailedAndTheSameInEveryBuild) { expect_same_in_every_build(make_machine()); }

TEST(Room, IsSoundDetailedAndTheSameInEveryBuild) { expect_same_in_every_build(make_room()); }

TEST(Garden, IsSoundDetailedAndTheSameInEveryBuild) { expect_same_in_every_build(make_garden()); }

TEST(Garden, ShowsASkyBelowWhiteWhereThereIsNoToneCurve) {
    const BuiltinScene entry = make_garden();
    const renderer::Lighting light = entry.lighting(Validity::kModerate);
    ASSERT_FALSE(light.tone_mapping.has_value());
    const renderer::Environment& sky = *light.environment;
    int seen = 0;
    int clipped = 0;
    for (const renderer::Camera& camera : entry.build().cameras) {
        const glm::vec3 ahead = glm::normalize(camera.target_m - camera.position_m);
        for (int row = 0; row < sky.height / 2; ++row) {
            for (int column = 0; column < sky.width; ++column) {
                const glm::vec3 way = renderer::direction_of_texel(sky, column, row);
                if (glm::dot(way, ahead) < std::cos(camera.vertical_fov_rad)) continue;
                const auto texel = static_cast<std::size_t>(row * sky.width + column);
                const glm::vec3& radiance = sky.radiance[texel];
                ++seen;
                if (std::max({radiance.x, radiance.y, radiance.z}) > 1.0F) ++clipped;
            }
        }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_LT(clipped, seen / 50);
}

TEST(BuiltinScenes, LightEachLevelAsItIsDefined) {
    for (const BuiltinScene& entry : builtin_scenes()) {
        for (const Validity level : entry.levels) {
            SCOPED_TRACE(entry.id);
            const renderer::Lighting light = entry.lighting(level);
            EXPECT_EQ(light.environment == nullptr, level == Validity::kLow);
            EXPECT_EQ(light.lights.empty(), level != Validity::kHigh);
            EXPECT_TRUE(level == Validity::kHigh || light.point_lights.empty());
            // Indoors there is a hundred times less light than outside, and both in one image.
            EXPECT_EQ(light.tone_mapping.has_value(),
                      level == Validity::kHigh || light.irradiance_probes);
            EXPECT_EQ(light.normal_mapping, level == Validity::kHigh);
            for (const renderer::DirectionalLight& sun : light.lights) {
                EXPECT_NEAR(glm::length(sun.towards_light), 1.0F, 1e-5F);
            }
        }
    }
}

TEST(BuiltinScenes, EachLevelHasMoreThanTheThesisScenes) {
    for (const Validity level : kValidities) {
        int more = 0;
        for (const BuiltinScene& entry : builtin_scenes()) {
            if (!entry.stands_in_for.empty()) continue;
            for (const Validity has : entry.levels) more += has == level ? 1 : 0;
        }
        EXPECT_GE(more, 1) << to_string(level);
    }
}

}  // namespace
}  // namespace obscura::stimuli
