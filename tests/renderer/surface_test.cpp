// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "renderer/scene/surface_conversion.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kSize = 64;

double srgb(double linear) {
    return 255.0 *
           (linear < 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

/// A texture whose left half is opaque and whose right half is empty.
Texture half_empty() {
    Texture texture{"half", 2, 1, true, {255, 255, 255, 255, 255, 255, 255, 0}};
    return texture;
}

/// Adds a material and gives it to the mesh added last.
Material& new_material(Scene& scene) {
    scene.materials.emplace_back();
    scene.meshes.back().material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    return scene.materials.back();
}

void add_wall(Scene& scene, float distance_m) {
    const float half_m = 4.0F * distance_m;
    tests::add_quad(scene, {-half_m, -half_m, -distance_m}, {2.0F * half_m, 0.0F, 0.0F},
                    {0.0F, 2.0F * half_m, 0.0F});
}

class Surface : public testing::Test {
  protected:
    Frame render(const Scene& scene, const Lighting& lighting, const FrameOptions& options = {},
                 const Variant& choice = {}) {
        const GpuScene gpu(scene);
        return renderer_.render({gpu, lighting, tests::forward_camera(), options}, choice, kSize,
                                kSize);
    }
    static int at(const Frame& frame, int column, int row, int channel = 0) {
        return frame.read_display()[3 * (static_cast<std::size_t>(row) * kSize + column) + channel];
    }
    static int middle(const Frame& frame) { return at(frame, kSize / 2, kSize / 2); }

    HeadlessContext context_;
    Renderer renderer_;
};

TEST_F(Surface, ThereIsNothingWhereACutOutTextureIsEmpty) {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-1.0F, -1.0F, -2.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F});
    scene.textures.push_back(half_empty());
    Material& material = new_material(scene);
    material.albedo_texture = 0;
    material.coverage = Coverage::kCutOut;
    const Frame frame = render(scene, {}, {.all_buffers = true});
    const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
    EXPECT_NEAR(depth_m[kSize * kSize / 2 + 24], 2.0F, 1e-5F);
    EXPECT_GE(depth_m[kSize * kSize / 2 + 40], 1e17F);
}

TEST_F(Surface, TheShadowOfACutOutSurfaceHasItsHoles) {
    // A card between a light from the camera's side and a wall; the light comes slightly from above
    // so that the card's shadow falls below the card.
    Scene scene = tests::empty_scene();
    add_wall(scene, 6.0F);
    tests::add_quad(scene, {-1.0F, 1.5F, -3.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F});
    scene.textures.push_back(half_empty());
    Material& material = new_material(scene);
    material.albedo_texture = 0;
    material.coverage = Coverage::kCutOut;
    material.double_sided = true;
    Lighting lighting;
    lighting.ambient = glm::vec3(0.0F);
    lighting.lights.push_back({glm::normalize(glm::vec3(0.0F, 1.0F, 1.5F)), glm::vec3(kPi)});
    const Frame frame = render(scene, lighting);
    // 3 m behind the card the shadow has sunk by 2 m: y from -0.5 to 0.5 on the wall at 6 m.
    EXPECT_LT(at(frame, kSize / 2 - 4, kSize / 2), 10);
    EXPECT_GT(at(frame, kSize / 2 + 5, kSize / 2), 100);
}

TEST_F(Surface, ABlendedSurfaceIsMixedInLinearLight) {
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.8F);
    add_wall(scene, 4.0F);
    add_wall(scene, 2.0F);
    Material& material = new_material(scene);
    material.albedo = glm::vec3(0.2F);
    material.opacity = 0.25F;
    material.coverage = Coverage::kBlended;
    EXPECT_NEAR(middle(render(scene, {})), srgb(0.25 * 0.2 + 0.75 * 0.8), 1.0);
}

TEST_F(Surface, BlendedSurfacesAreMixedBackToFrontWhateverTheirOrderInTheScene) {
    for (const bool far_first : {true, false}) {
        Scene scene = tests::empty_scene();
        scene.materials[0].albedo = glm::vec3(0.0F);
        add_wall(scene, 8.0F);
        for (const bool far : {far_first, !far_first}) {
            add_wall(scene, far ? 4.0F : 2.0F);
            Material& material = new_material(scene);
            material.albedo = glm::vec3(far ? 1.0F : 0.0F);
            material.opacity = 0.5F;
            material.coverage = Coverage::kBlended;
        }
        EXPECT_NEAR(middle(render(scene, {})), srgb(0.25), 1.0) << far_first;
    }
}

TEST_F(Surface, OnlyANearlyOpaqueBlendedSurfaceIsSeenByTheTechniqueAndOnlyWhereAsked) {
    Scene scene = tests::facing_wall(8.0F);
    add_wall(scene, 2.0F);
    Material& material = new_material(scene);
    material.opacity = 0.95F;
    material.coverage = Coverage::kBlended;
    const Variant crytek{"crytek", 24, {}, "none"};
    const Frame asked = render(scene, {}, {.occluding_opacity = 0.9F}, crytek);
    EXPECT_NEAR(asked.read_floats(Target::kOccluderDepth)[kSize * kSize / 2 + 32], 2.0F, 1e-5F);
    EXPECT_NEAR(asked.read_floats(Target::kDepth)[kSize * kSize / 2 + 32], 8.0F, 1e-5F);
    const Frame thinner = render(scene, {}, {.occluding_opacity = 0.96F}, crytek);
    EXPECT_NEAR(thinner.read_floats(Target::kOccluderDepth)[kSize * kSize / 2 + 32], 8.0F, 1e-5F);
    EXPECT_EQ(render(scene, {}, {}, crytek).plan().find(Target::kOccluderDepth), nullptr);
}

TEST_F(Surface, APointLightFallsWithTheSquareOfTheDistance) {
    for (const float distance_m : {1.0F, 2.0F, 3.0F}) {
        const Scene scene = tests::facing_wall(4.0F);
        Lighting lighting;
        lighting.ambient = glm::vec3(0.0F);
        PointLight light;
        light.position_m = {0.0F, 0.0F, -4.0F + distance_m};
        light.intensity = glm::vec3(kPi);
        lighting.point_lights.push_back(light);
        const double linear = std::min(1.0, 1.0 / (distance_m * distance_m));
        // The middle of the image lies between four pixels.
        EXPECT_NEAR(middle(render(scene, lighting)), srgb(linear), 2.0) << distance_m;
    }
}

TEST_F(Surface, APointLightCastsShadowsOnEverySide) {
    // Boxes on all sides of a light, each in front of a wall of a room around it; the camera looks
    // at one wall, and the room is turned.
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
        for (const float sign : {-1.0F, 1.0F}) {
            Scene scene = tests::empty_scene();
            tests::add_box(scene, glm::vec3(-5.0F), glm::vec3(5.0F));
            scene.materials[0].double_sided = true;
            const glm::vec3 along = sign * axis;
            const glm::vec3 across(axis.y, axis.z, axis.x);
            tests::add_box(scene, along * 3.0F - glm::vec3(0.5F), along * 3.0F + glm::vec3(0.5F));
            Lighting lighting;
            lighting.ambient = glm::vec3(0.0F);
            lighting.point_lights.push_back({});
            lighting.point_lights[0].position_m = glm::vec3(0.0F);
            lighting.point_lights[0].intensity = glm::vec3(25.0F * kPi);
            Camera camera = tests::forward_camera();
            // From behind the box's edge, at the wall beyond it.
            camera.position_m = along * 2.0F + across * 2.5F;
            camera.target_m = along * 5.0F;
            camera.up = glm::vec3(axis.z, axis.x, axis.y);
            const GpuScene gpu(scene);
            const auto pixel = [&](const glm::vec3& point) {
                const Frame frame = renderer_.render({gpu, lighting, camera}, {}, kSize, kSize);
                const CameraMatrices matrices = matrices_of(camera, kSize, kSize);
                const glm::vec4 clip =
                    matrices.clip_from_view * matrices.view_from_world * glm::vec4(point, 1.0F);
                const glm::vec2 uv = glm::vec2(clip) / clip.w * 0.5F + 0.5F;
                return at(frame, static_cast<int>(uv.x * kSize),
                          static_cast<int>((1.0F - uv.y) * kSize));
            };
            EXPECT_LT(pixel(along * 5.0F + across * 0.6F), 10) << axis.x << axis.y << sign;
            EXPECT_GT(pixel(along * 5.0F + across * 1.6F), 180) << axis.x << axis.y << sign;
        }
    }
}

TEST_F(Surface, ASpotLightEndsAtItsConeAndARangeEndsALight) {
    const Scene scene = tests::facing_wall(4.0F);
    Lighting lighting;
    lighting.ambient = glm::vec3(0.0F);
    PointLight light;
    light.position_m = {0.0F, 0.0F, -2.0F};
    light.intensity = glm::vec3(4.0F * kPi);
    light.direction = {0.0F, 0.0F, -1.0F};
    light.inner_cone_rad = 0.2F;
    light.outer_cone_rad = 0.3F;
    lighting.point_lights.push_back(light);
    // 2 m from the wall the cone's radius is 0.62 m; the image's half is 2.31 m.
    const Frame frame = render(scene, lighting);
    EXPECT_NEAR(middle(frame), 255, 3);
    EXPECT_EQ(at(frame, kSize / 2 + 11, kSize / 2), 0);
    lighting.point_lights[0].range_m = 1.9F;
    EXPECT_EQ(middle(render(scene, lighting)), 0);
}

TEST_F(Surface, EmittedLightIsAddedAndBakedAccessibilityScalesAmbientLightOnly) {
    Scene scene = tests::facing_wall(4.0F);
    scene.textures.push_back({"half open", 1, 1, false, {128, 0, 0, 255}});
    scene.materials[0].albedo = glm::vec3(0.5F);
    scene.materials[0].occlusion_texture = 0;
    scene.materials[0].emissive = {0.1F, 0.1F, 0.1F};
    Lighting lighting;
    lighting.ambient = glm::vec3(0.4F);
    lighting.lights.push_back({glm::vec3(0.0F, 0.0F, 1.0F), glm::vec3(0.2F * kPi)});
    for (const float strength : {0.0F, 0.5F, 1.0F}) {
        scene.materials[0].occlusion_strength = strength;
        const double open = 1.0 + strength * (128.0 / 255.0 - 1.0);
        EXPECT_NEAR(middle(render(scene, lighting)), srgb(0.5 * (0.4 * open + 0.2) + 0.1), 1.0);
    }
}

TEST_F(Surface, ATextureOfRoughnessGivesTheHighlightOfThatRoughness) {
    // Roughness 128 / 255 of a factor 0.9, half of it metal.
    const double roughness = 0.9 * 128.0 / 255.0;
    Scene textured = tests::facing_wall(4.0F);
    textured.textures.push_back({"half", 1, 1, false, {0, 128, 128, 255}});
    textured.materials[0].albedo = glm::vec3(0.3F, 0.2F, 0.1F);
    textured.materials[0].specular_intensity = 0.04F;
    Scene plain = textured;
    textured.materials[0].roughness_texture = 0;
    textured.materials[0].roughness = 0.9F;
    textured.materials[0].metalness = 1.0F;
    const double metal = (0.2126 * 0.3 + 0.7152 * 0.2 + 0.0722 * 0.1) * (1.0 - roughness);
    plain.materials[0].specular_intensity =
        static_cast<float>(std::lerp(0.04, metal, 128.0 / 255.0));
    plain.materials[0].specular_power = blinn_phong_power(roughness);
    Lighting lighting;
    lighting.lights.push_back({glm::normalize(glm::vec3(0.2F, 0.1F, 1.0F)), glm::vec3(0.8F)});
    const Frame wanted = render(plain, lighting);
    const Frame met = render(textured, lighting);
    ASSERT_TRUE(met.plan().needs.roughness);
    for (const int column : {8, 24, 32, 40, 56}) {
        EXPECT_NEAR(at(met, column, 32), at(wanted, column, 32), 1) << column;
    }
    EXPECT_GT(middle(met), at(met, 2, 60) + 5) << "no highlight";
    // Without lights there are no highlights, and nobody looks at the texture.
    EXPECT_FALSE(render(textured, {}).plan().needs.roughness);
}

TEST_F(Surface, SupersamplingAveragesInLinearLightAndLeavesFlatPartsAlone) {
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.0F);
    // An edge that halves the pixels of column 40: (40.5 / 32 - 1) tan 30.
    const float edge_m = (40.5F / 32.0F - 1.0F) * std::tan(kPi / 6.0F) * 5.0F;
    tests::add_quad(scene, {edge_m, -50.0F, -5.0F}, {50.0F, 0.0F, 0.0F}, {0.0F, 100.0F, 0.0F});
    const Frame once = render(scene, {});
    const Frame often = render(scene, {}, {.supersampling = 2});
    EXPECT_EQ(at(often, 10, 32), 255);
    EXPECT_EQ(at(often, 50, 32), 0);
    EXPECT_TRUE(at(once, 40, 32) == 0 || at(once, 40, 32) == 255);
    EXPECT_NEAR(at(often, 40, 32), srgb(0.5), 1.0);
    EXPECT_EQ(often.read_display().size(), 3U * kSize * kSize);
}

TEST_F(Surface, EachToneCurveMeetsItsPublishedValues) {
    Scene scene = tests::facing_wall(4.0F);
    Lighting lighting;
    const auto shown = [&](float radiance, ToneMapping tone) {
        lighting.ambient = glm::vec3(radiance);
        lighting.tone_mapping = tone;
        return middle(render(scene, lighting));
    };
    // Reinhard: L (1 + L / W^2) / (1 + L).
    EXPECT_NEAR(shown(2.0F, {1.0F, 4.0F, ToneCurve::kReinhard}), srgb(2.0 * 1.125 / 3.0), 1.0);
    EXPECT_NEAR(shown(4.0F, {1.0F, 4.0F, ToneCurve::kReinhard}), 255, 1.0);
    // Hable: his white point, 11.2, becomes 1; f(1) / f(11.2) = 0.18 / 0.7249 by his formula.
    EXPECT_NEAR(shown(11.2F, {1.0F, 11.2F, ToneCurve::kFilmic}), 255, 1.0);
    const auto hable = [](double x) {
        return (x * (0.15 * x + 0.10 * 0.50) + 0.20 * 0.02) /
                   (x * (0.15 * x + 0.50) + 0.20 * 0.30) -
               0.02 / 0.30;
    };
    EXPECT_NEAR(shown(1.0F, {1.0F, 11.2F, ToneCurve::kFilmic}), srgb(hable(1.0) / hable(11.2)),
                1.0);
    // Narkowicz: 1 becomes 2.54 / 3.16.
    EXPECT_NEAR(shown(1.0F, {1.0F, 4.0F, ToneCurve::kAces}), srgb(2.54 / 3.16), 1.0);
    EXPECT_NEAR(shown(0.5F, {0.5F, 1.0F, ToneCurve::kClip}), srgb(0.25), 1.0);
    EXPECT_EQ(shown(2.0F, {1.0F, 1.0F, ToneCurve::kClip}), 255);
}

}  // namespace
}  // namespace obscura::renderer
