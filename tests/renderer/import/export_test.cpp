// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/export/gltf_export.h"
#include "renderer/gl/context.h"
#include "tests/renderer/import/glb_maker.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using tests::plain_texture;

/// Boxes on a floor with textures, a normal map, colours and a highlight.
Scene small_scene() {
    Scene scene = tests::empty_scene();
    Texture stripes = plain_texture(16, {200, 120, 60, 255});
    Texture normals = plain_texture(16, {128, 128, 255, 255});
    for (std::size_t i = 0; i < 16 * 16; ++i) {
        stripes.rgba[4 * i + 1] = static_cast<std::uint8_t>(i % 16 < 8 ? 120 : 40);
        normals.rgba[4 * i] = static_cast<std::uint8_t>(i % 5 == 0 ? 160 : 128);
    }
    normals.srgb = false;
    Texture gloss = plain_texture(4, {0, 140, 0, 255});
    for (std::size_t i = 0; i < 16; ++i) gloss.rgba[4 * i + 1] = static_cast<std::uint8_t>(9 * i);
    gloss.srgb = false;
    scene.textures = {stripes, normals, gloss};
    Material painted{.name = "painted", .albedo = {0.9F, 0.8F, 0.7F}};
    painted.specular_intensity = 0.3F;
    painted.specular_power = 40.0F;
    painted.albedo_texture = 0;
    painted.normal_texture = 1;
    Material glowing{.name = "glowing", .double_sided = true};
    glowing.emissive = {3.0F, 1.5F, 0.0F};
    Material worn{.name = "worn", .specular_intensity = 0.1F};
    worn.roughness_texture = 2;
    worn.roughness = 0.9F;
    worn.metalness = 0.2F;
    scene.materials = {painted, glowing, {.name = "matt", .specular_intensity = 0.0F}, worn};
    tests::add_quad(scene, {-4.0F, -1.0F, 0.0F}, {8.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -10.0F});
    scene.meshes.back().material = 2;
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {0.5F, 0.5F, -4.0F});
    tests::add_quad(scene, {0.7F, -0.9F, -4.0F}, {0.5F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F});
    scene.meshes.back().material = 1;
    for (Vertex& vertex : scene.meshes[2].vertices) vertex.color = {255, 130, 7, 255};
    tests::add_quad(scene, {-2.4F, -1.0F, -5.0F}, {1.0F, 0.0F, 0.2F}, {0.0F, 1.6F, 0.0F});
    scene.meshes.back().material = 3;
    Camera camera = tests::forward_camera();
    camera.position_m = {0.31F, 0.47F, 1.1F};
    camera.target_m = {-0.2F, -0.1F, -5.0F};
    scene.cameras = {camera, tests::forward_camera()};
    scene.cameras[1].name = "level";
    return scene;
}

Lighting small_light() {
    Lighting lighting;
    lighting.environment = std::make_shared<Environment>(make_sky({}, 64));
    lighting.lights = {{glm::normalize(glm::vec3(1.0F, 2.0F, 1.0F)), {3.0F, 2.5F, 2.0F}}};
    lighting.point_lights.push_back({.position_m = {1.0F, 1.0F, -3.0F}, .intensity = {2, 2, 1}});
    lighting.normal_mapping = true;
    lighting.tone_mapping.emplace();
    return lighting;
}

ImportedScene round_trip(const Scene& scene, const Lighting& lighting) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "scene.glb", to_glb(scene, lighting));
    return import_scene(folder / "scene.glb");
}

TEST(Export, ImportingAgainGivesTheSameGeometrySurfacesAndViews) {
    const Scene scene = small_scene();
    const ImportedScene imported = round_trip(scene, small_light());
    ASSERT_EQ(imported.scene.meshes.size(), scene.meshes.size());
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& before = scene.meshes[m];
        const Mesh& after = imported.scene.meshes[m];
        EXPECT_EQ(after.indices, before.indices);
        EXPECT_EQ(after.material, before.material);
        ASSERT_EQ(after.vertices.size(), before.vertices.size());
        for (std::size_t v = 0; v < before.vertices.size(); ++v) {
            EXPECT_EQ(after.vertices[v].position_m, before.vertices[v].position_m);
            EXPECT_EQ(after.vertices[v].normal, before.vertices[v].normal);
            EXPECT_EQ(after.vertices[v].uv, before.vertices[v].uv);
            EXPECT_EQ(after.vertices[v].color, before.vertices[v].color);
            if (before.material == 0) {
                EXPECT_EQ(after.vertices[v].tangent, before.vertices[v].tangent);
            }
        }
    }
    ASSERT_EQ(imported.scene.materials.size(), scene.materials.size());
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const Material& before = scene.materials[m];
        const Material& after = imported.scene.materials[m];
        EXPECT_EQ(after.name, before.name);
        EXPECT_NEAR(after.specular_intensity, before.specular_intensity, 1e-5F);
        EXPECT_EQ(after.roughness_texture, before.roughness_texture < 0 ? kNoTexture : 2);
        if (before.roughness_texture == kNoTexture) {
            EXPECT_NEAR(after.specular_power, before.specular_power, 1e-3F);
        } else {
            EXPECT_FLOAT_EQ(after.roughness, before.roughness);
            EXPECT_FLOAT_EQ(after.metalness, before.metalness);
        }
        EXPECT_NEAR(glm::distance(after.emissive, before.emissive), 0.0F, 1e-5F);
        EXPECT_EQ(after.double_sided, before.double_sided);
        EXPECT_EQ(after.coverage, before.coverage);
    }
    ASSERT_EQ(imported.scene.textures.size(), 3U);
    for (std::size_t t = 0; t < 3; ++t) {
        EXPECT_EQ(imported.scene.textures[t].rgba, scene.textures[t].rgba);
        EXPECT_EQ(imported.scene.textures[t].srgb, scene.textures[t].srgb);
    }
    ASSERT_EQ(imported.scene.cameras.size(), 2U);
    EXPECT_EQ(imported.scene.cameras[1].name, "level");
    EXPECT_EQ(imported.scene.cameras[0].target_m, scene.cameras[0].target_m);
    EXPECT_THAT(imported.notes, testing::IsEmpty());
}

TEST(Export, LightsKeepDirectionAndStrength) {
    const Lighting before = small_light();
    const ImportedScene imported = round_trip(small_scene(), before);
    ASSERT_EQ(imported.lights.size(), 1U);
    EXPECT_EQ(imported.lights[0].towards_light, before.lights[0].towards_light);
    EXPECT_EQ(imported.lights[0].irradiance, before.lights[0].irradiance);
    ASSERT_EQ(imported.point_lights.size(), 1U);
    EXPECT_EQ(imported.point_lights[0].position_m, before.point_lights[0].position_m);
    EXPECT_GT(imported.point_lights[0].outer_cone_rad, 3.0F);
}

TEST(Export, TheSameSceneGivesTheSameBytesWhoseLengthsAgree) {
    const std::string bytes = to_glb(small_scene(), small_light());
    EXPECT_EQ(bytes, to_glb(small_scene(), small_light()));
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 8, sizeof length);
    EXPECT_EQ(length, bytes.size());
    EXPECT_EQ(bytes.size() % 4, 0U);
}

TEST(Export, ASceneThatCannotBeDrawnIsRefused) {
    Scene scene = small_scene();
    scene.meshes[0].indices[0] = 99;
    EXPECT_THROW((void)to_glb(scene, {}), base::Error);
    scene = small_scene();
    scene.meshes[0].vertices[0].position_m.x = std::nanf("");
    EXPECT_THROW((void)to_glb(scene, {}), base::Error);
    scene = small_scene();
    scene.meshes.clear();
    EXPECT_THROW((void)to_glb(scene, {}), base::Error);
}

std::vector<std::uint8_t> image_of(Renderer& renderer, const Scene& scene, const Camera& camera,
                                   const Lighting& lighting) {
    const Variant choice{"blizzard", 24, {}, "separable"};
    const GpuScene gpu(scene);
    return renderer.render({gpu, lighting, camera}, choice, 160, 90).read_display();
}

TEST(ExportImage, ImportingAgainGivesTheSameImageWithinRounding) {
    const HeadlessContext context;
    Renderer renderer;
    const Scene scene = small_scene();
    Lighting lighting = small_light();
    const ImportedScene imported = round_trip(scene, lighting);
    const auto before = image_of(renderer, scene, scene.cameras[0], lighting);
    lighting.lights = imported.lights;
    lighting.point_lights = imported.point_lights;
    const auto after = image_of(renderer, imported.scene, imported.scene.cameras[0], lighting);
    ASSERT_EQ(before.size(), after.size());
    int different = 0;
    int largest = 0;
    int contrast = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const int difference = std::abs(int{before[i]} - int{after[i]});
        if (difference > 0) ++different;
        largest = std::max(largest, difference);
        contrast = std::max(contrast, std::abs(int{before[i]} - int{before[0]}));
    }
    EXPECT_GT(contrast, 50);  // there is something to see
    EXPECT_LE(largest, 1);
    EXPECT_LT(different, static_cast<int>(before.size()) / 100);
}

}  // namespace
}  // namespace obscura::renderer
