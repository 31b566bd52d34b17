// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/scene/surface_conversion.h"
#include "tests/renderer/import/glb_maker.h"

namespace obscura::renderer {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tests::expect_near;
using tests::GlbMaker;
using tests::plain_texture;
using tests::triangle_glb;

TEST(GltfMaterial, SurfacesBecomeWhatTheGBufferHolds) {
    GlbMaker glb = triangle_glb();
    const int texture = glb.add_image(plain_texture(2, {10, 20, 30, 128}));
    glb.json["materials"] = {{{"name", "leaf"},
                              {"doubleSided", true},
                              {"alphaMode", "MASK"},
                              {"alphaCutoff", 0.3},
                              {"emissiveFactor", {0.5, 0.25, 0.0}},
                              {"occlusionTexture", {{"index", texture}, {"strength", 0.7}}},
                              {"pbrMetallicRoughness",
                               {{"baseColorFactor", {0.5, 0.25, 0.125, 0.75}},
                                {"baseColorTexture", {{"index", texture}}},
                                {"metallicFactor", 0.0},
                                {"roughnessFactor", 0.5}}}}};
    glb.json["materials"][0]["extensions"]["KHR_materials_emissive_strength"] = {
        {"emissiveStrength", 4.0}};
    const Scene scene = glb.import().scene;
    const Material& leaf = scene.materials[0];
    expect_near(leaf.albedo, {0.5, 0.25, 0.125});
    EXPECT_FLOAT_EQ(leaf.opacity, 0.75F);
    EXPECT_EQ(leaf.coverage, Coverage::kCutOut);
    EXPECT_FLOAT_EQ(leaf.alpha_cutoff, 0.3F);
    EXPECT_TRUE(leaf.double_sided);
    expect_near(leaf.emissive, {2.0, 1.0, 0.0});
    EXPECT_FLOAT_EQ(leaf.occlusion_strength, 0.7F);
    EXPECT_NEAR(leaf.specular_intensity, 0.04F, 1e-6F);            // index of refraction 1.5
    EXPECT_NEAR(leaf.specular_power, 2.0F * 16.0F - 2.0F, 1e-3F);  // alpha = 1/4
    // Colour and baked occlusion are decoded differently, so they are two textures.
    ASSERT_EQ(scene.textures.size(), 2U);
    EXPECT_TRUE(scene.textures[static_cast<std::size_t>(leaf.albedo_texture)].srgb);
    EXPECT_FALSE(scene.textures[static_cast<std::size_t>(leaf.occlusion_texture)].srgb);
    // Alpha is not multiplied into the colour.
    EXPECT_THAT(
        std::vector<int>(scene.textures[0].rgba.begin(), scene.textures[0].rgba.begin() + 4),
        testing::ElementsAre(10, 20, 30, 128));
}

TEST(GltfMaterial, AnIndexOfRefractionAndItsReflectanceAreInverse) {
    for (const double reflectance : {0.0, 0.02, 0.04, 0.3, 0.9}) {
        EXPECT_NEAR(reflectance_of_ior(ior_of_reflectance(reflectance)), reflectance, 1e-12);
    }
    EXPECT_NEAR(reflectance_of_ior(1.5), 0.04, 1e-12);
    for (const double power : {1.0, 16.0, 80.0, 255.0}) {
        EXPECT_NEAR(blinn_phong_power(roughness_of_power(power)), power, 1e-3);
    }
}

TEST(GltfMaterial, AMetalIsNotedAsApproximated) {
    GlbMaker glb = triangle_glb();
    glb.json["materials"][0]["pbrMetallicRoughness"] = {{"metallicFactor", 1.0},
                                                        {"roughnessFactor", 0.25}};
    const ImportedScene imported = glb.import();
    EXPECT_THAT(imported.notes, Contains(HasSubstr("metals are approximated")));
    EXPECT_NEAR(imported.scene.materials[0].specular_intensity, 0.75F, 1e-5F);
}

TEST(GltfMaterial, AMetallicRoughnessTextureIsKeptWithItsFactors) {
    GlbMaker glb = triangle_glb();
    const int texture = glb.add_image(plain_texture(4, {0, 51, 0, 255}));  // roughness 0.2
    glb.json["materials"][0]["pbrMetallicRoughness"] = {
        {"metallicRoughnessTexture", {{"index", texture}}},
        {"roughnessFactor", 0.8},
        {"metallicFactor", 0.6}};
    const ImportedScene imported = glb.import();
    const Material& material = imported.scene.materials[0];
    ASSERT_EQ(material.roughness_texture, 0);
    EXPECT_EQ(imported.scene.textures[0].rgba[1], 51);
    EXPECT_FALSE(imported.scene.textures[0].srgb);
    EXPECT_FLOAT_EQ(material.roughness, 0.8F);
    EXPECT_FLOAT_EQ(material.metalness, 0.6F);
    // Of the part that is no metal; the texture says where there is none.
    EXPECT_NEAR(material.specular_intensity, 0.04F, 1e-6F);
    EXPECT_THAT(imported.notes, testing::Not(Contains(HasSubstr("metal"))));
}

TEST(GltfMaterial, AMetallicRoughnessTextureThatLiesElsewhereCountsByItsMean) {
    GlbMaker glb = triangle_glb();
    const int colour = glb.add_image(plain_texture(2, {200, 100, 50, 255}));
    const int rough = glb.add_image(plain_texture(4, {0, 128, 0, 255}));  // and no metal
    glb.json["materials"][0]["pbrMetallicRoughness"] = {
        {"baseColorTexture",
         {{"index", colour}, {"extensions", {{"KHR_texture_transform", {{"scale", {4.0, 4.0}}}}}}}},
        {"metallicRoughnessTexture", {{"index", rough}}},
        {"roughnessFactor", 0.8}};
    const ImportedScene imported = glb.import();
    const Material& material = imported.scene.materials[0];
    EXPECT_EQ(material.roughness_texture, kNoTexture);
    EXPECT_EQ(imported.scene.textures.size(), 1U);
    EXPECT_NEAR(material.specular_power, blinn_phong_power(0.8 * 128.0 / 255.0), 1e-2F);
    EXPECT_NEAR(material.specular_intensity, 0.04F, 1e-6F);
    EXPECT_THAT(imported.notes, Contains(HasSubstr("replaced by their mean")));
}

TEST(GltfMaterial, AMetallicRoughnessTextureLeavesOtherTexturesTheirCoordinates) {
    GlbMaker glb = triangle_glb();
    const int rough = glb.add_image(plain_texture(4, {0, 128, 0, 255}));
    const int baked = glb.add_image(plain_texture(2, {90, 0, 0, 255}));
    glb.json["materials"][0]["pbrMetallicRoughness"] = {
        {"metallicRoughnessTexture", {{"index", rough}}}};
    glb.json["materials"][0]["occlusionTexture"] = {
        {"index", baked}, {"extensions", {{"KHR_texture_transform", {{"scale", {2.0, 2.0}}}}}}};
    const Material material = glb.import().scene.materials[0];
    EXPECT_NE(material.occlusion_texture, kNoTexture);
    EXPECT_EQ(material.roughness_texture, kNoTexture);
}

TEST(GltfMaterial, AMissingMetallicRoughnessTextureLeavesTheFactors) {
    GlbMaker glb = triangle_glb();
    glb.json["images"].push_back({{"uri", "absent.png"}});
    glb.json["textures"].push_back({{"source", 0}});
    glb.json["materials"][0]["pbrMetallicRoughness"] = {
        {"metallicRoughnessTexture", {{"index", 0}}},
        {"roughnessFactor", 0.5},
        {"metallicFactor", 0.0}};
    const ImportedScene imported = glb.import();
    EXPECT_EQ(imported.scene.materials[0].roughness_texture, kNoTexture);
    EXPECT_NEAR(imported.scene.materials[0].specular_power, blinn_phong_power(0.5), 1e-3F);
    EXPECT_THAT(imported.notes, Contains(HasSubstr("absent.png")));
}

}  // namespace
}  // namespace obscura::renderer
