// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/import/mesh_finish.h"
#include "tests/renderer/import/glb_maker.h"

namespace obscura::renderer {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tests::expect_near;
using tests::GlbMaker;
using tests::plain_texture;
using tests::triangle_glb;
using Json = nlohmann::json;

glm::vec3 face_normal(const Mesh& mesh, std::size_t triangle = 0) {
    const auto corner = [&](std::size_t k) {
        return mesh.vertices[mesh.indices[3 * triangle + k]].position_m;
    };
    return glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
}

TEST(GltfImport, ReadsWhatATriangleHolds) {
    const ImportedScene imported = triangle_glb().import();
    ASSERT_EQ(imported.scene.meshes.size(), 1U);
    const Mesh& mesh = imported.scene.meshes[0];
    EXPECT_EQ(mesh.name, "triangle");
    EXPECT_EQ(imported.scene.triangle_count(), 1U);
    expect_near(mesh.vertices[1].position_m, {1, 0, 0}, 0.0F);
    expect_near(mesh.vertices[1].normal, {0, 0, 1}, 0.0F);
    EXPECT_EQ(mesh.vertices[1].uv, glm::vec2(1.0F, 1.0F));
    EXPECT_EQ(imported.scene.materials[mesh.material].name, "plain");
    ASSERT_EQ(imported.files.size(), 1U);
    EXPECT_EQ(imported.files[0].sha256.size(), 64U);
}

TEST(GltfImport, AFileWithoutCameraGetsOneThatSeesEverything) {
    const ImportedScene imported = triangle_glb().import();
    ASSERT_EQ(imported.scene.cameras.size(), 1U);
    const Camera& camera = imported.scene.cameras[0];
    EXPECT_EQ(camera.name, kOverviewCamera);
    const glm::vec3 forward = glm::normalize(camera.target_m - camera.position_m);
    for (const Vertex& vertex : imported.scene.meshes[0].vertices) {
        const glm::vec3 to = vertex.position_m - camera.position_m;
        EXPECT_GT(glm::dot(to, forward), camera.near_m);
        EXPECT_LT(glm::dot(to, forward), camera.far_m);
        const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
        const float most = std::tan(0.5F * camera.vertical_fov_rad) * glm::dot(to, forward);
        EXPECT_LT(std::abs(glm::dot(to, right)), most);
        EXPECT_LT(std::abs(glm::dot(to, glm::cross(right, forward))), most);
    }
}

TEST(GltfImport, NodesPlaceTheirMeshesAndScaleTurnsUnitsIntoMetres) {
    GlbMaker glb = triangle_glb();
    glb.json["nodes"] = {
        {{"children", {1}}, {"translation", {10, 0, 0}}},
        {{"mesh", 0},
         {"rotation", {0, std::sin(std::numbers::pi / 4), 0, std::cos(std::numbers::pi / 4)}},
         {"scale", {2, 2, 2}}}};
    const ImportedScene imported = glb.import({.scale = 0.5});
    const Mesh& mesh = imported.scene.meshes[0];
    // Doubled, turned by 90 degrees about Y (+X to -Z, +Z to +X), moved by 10, halved.
    expect_near(mesh.vertices[1].position_m, {5, 0, -1});
    expect_near(mesh.vertices[2].position_m, {5, 1, 0});
    expect_near(mesh.vertices[0].normal, {1, 0, 0});
    expect_near(face_normal(mesh), {1, 0, 0});
}

TEST(GltfImport, AMirroredNodeTurnsWindingsSoThatTheOutsideStaysOutside) {
    GlbMaker glb = triangle_glb();
    glb.json["nodes"][0]["scale"] = {1, 1, -1};
    const Mesh mesh = glb.import().scene.meshes[0];
    expect_near(mesh.vertices[0].normal, {0, 0, -1});
    expect_near(face_normal(mesh), {0, 0, -1});
}

TEST(GltfImport, UnevenScaleKeepsNormalsPerpendicular) {
    GlbMaker glb = triangle_glb();
    glb.json["nodes"][0]["matrix"] = {1, 0, 0.5, 0, 0, 3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const Mesh mesh = glb.import().scene.meshes[0];
    expect_near(mesh.vertices[0].normal, face_normal(mesh));
}

TEST(GltfImport, ASkinnedMeshStandsInThePoseOfItsJointsWhateverItsOwnNodeSays) {
    GlbMaker glb = triangle_glb();
    const int joints =
        glb.add_accessor<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 5121, 3);
    const int weights = glb.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0.5, 0, 0}, "VEC4", 4);
    // Joint 1 was bound at x = 1 and now stands at (1, 0, 5).
    std::vector<float> inverse(32, 0.0F);
    for (const std::size_t i : {0U, 5U, 10U, 15U, 16U, 21U, 26U, 31U}) inverse[i] = 1.0F;
    inverse[28] = -1.0F;
    const int matrices = glb.add_floats(inverse, "MAT4", 16);
    Json& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = joints;
    attributes["WEIGHTS_0"] = weights;
    glb.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
    glb.json["scenes"][0]["nodes"] = {0, 1, 2};
    glb.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}},
                         {{"name", "root"}},
                         {{"name", "arm"}, {"translation", {1, 0, 5}}}};
    const Mesh mesh = glb.import().scene.meshes[0];
    expect_near(mesh.vertices[0].position_m, {0, 0, 0});
    expect_near(mesh.vertices[1].position_m, {1, 0, 5});
    expect_near(mesh.vertices[2].position_m, {0, 1, 2.5});
}

TEST(GltfImport, TrianglesThatTurnAgainstTheirNormalsAreNoted) {
    GlbMaker glb = triangle_glb();
    EXPECT_THAT(glb.import().notes, testing::Not(Contains(HasSubstr("points to their back"))));
    Scene scene = glb.import().scene;
    std::swap(scene.meshes[0].indices[0], scene.meshes[0].indices[1]);
    const import_detail::Sides sides = import_detail::sides_of(scene.meshes[0]);
    EXPECT_EQ(sides.with_area, 1U);
    EXPECT_EQ(sides.with_turned_normal, 1U);
}

TEST(GltfImport, MissingTangentsPointAlongUAndTheBitangentUpInTheImage) {
    GlbMaker glb = triangle_glb();
    const int texture = glb.add_image(plain_texture(2, {128, 128, 255, 255}));
    glb.json["materials"][0]["normalTexture"] = {{"index", texture}};
    const Mesh mesh = glb.import().scene.meshes[0];
    for (const Vertex& vertex : mesh.vertices) {
        expect_near(glm::vec3(vertex.tangent), {1, 0, 0});
        // v runs down and +Y of the triangle is up: cross(n, t) * w must be +Y.
        expect_near(glm::cross(vertex.normal, glm::vec3(vertex.tangent)) * vertex.tangent.w,
                    {0, 1, 0});
    }
}

TEST(GltfImport, ATexturesTransformMovesTheCoordinates) {
    GlbMaker glb = triangle_glb();
    const int texture = glb.add_image(plain_texture(2, {128, 128, 255, 255}));
    Json info = {{"index", texture}};
    info["extensions"]["KHR_texture_transform"] = {{"offset", {0.25, 0.5}}, {"scale", {2, 4}}};
    glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = info;
    const Mesh mesh = glb.import().scene.meshes[0];
    EXPECT_EQ(mesh.vertices[1].uv, glm::vec2(2.25F, 4.5F));
}

TEST(GltfImport, MissingNormalsAreThoseOfTheTriangles) {
    GlbMaker glb = triangle_glb();
    glb.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
    const ImportedScene imported = glb.import();
    for (const Vertex& vertex : imported.scene.meshes[0].vertices) {
        expect_near(vertex.normal, {0, 0, 1});
    }
    EXPECT_THAT(imported.notes, Contains(HasSubstr("without normals")));
}

TEST(GltfImport, StripsAndFansBecomeTrianglesOfOneFacing) {
    for (const int mode : {5, 6}) {
        GlbMaker glb = triangle_glb();
        Json& primitive = glb.json["meshes"][0]["primitives"][0];
        const std::vector<float> quad =
            mode == 5 ? std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}
                      : std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
        primitive["attributes"] = {{"POSITION", glb.add_floats(quad, "VEC3", 3)}};
        primitive.erase("indices");
        primitive["mode"] = mode;
        const Scene scene = glb.import().scene;
        ASSERT_EQ(scene.triangle_count(), 2U) << mode;
        expect_near(face_normal(scene.meshes[0], 0), {0, 0, 1});
        expect_near(face_normal(scene.meshes[0], 1), {0, 0, 1});
    }
}

TEST(GltfImport, VertexColoursSparseAccessorsAndMorphWeightsCount) {
    GlbMaker glb = triangle_glb();
    Json& primitive = glb.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["COLOR_0"] =
        glb.add_accessor<std::uint16_t>({65535, 0, 0, 0, 65535, 0, 0, 0, 32768}, "VEC3", 5123, 3);
    glb.json["accessors"].back()["normalized"] = true;
    // A target that moves the last vertex by 2 along z, all zeros but for one sparse element.
    const std::uint32_t index = 2;
    const float moved[3] = {0, 0, 2};
    const int indices = glb.add_view(&index, sizeof index);
    const int values = glb.add_view(moved, sizeof moved);
    glb.json["accessors"].push_back(
        {{"componentType", 5126},
         {"type", "VEC3"},
         {"count", 3},
         {"sparse",
          {{"count", 1},
           {"indices", {{"bufferView", indices}, {"componentType", 5125}}},
           {"values", {{"bufferView", values}}}}}});
    primitive["targets"] = {{{"POSITION", glb.json["accessors"].size() - 1}}};
    glb.json["meshes"][0]["weights"] = {0.5};
    const Mesh mesh = glb.import().scene.meshes[0];
    EXPECT_EQ(mesh.vertices[0].color, glm::u8vec4(255, 0, 0, 255));
    EXPECT_EQ(mesh.vertices[2].color, glm::u8vec4(0, 0, 128, 255));
    expect_near(mesh.vertices[2].position_m, {0, 1, 1});
}

TEST(GltfImport, CamerasAndLightsKeepNameAimAndStrength) {
    GlbMaker glb = triangle_glb();
    glb.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"zfar", 50.0}}}},
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
    glb.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 3.0}, {"color", {1.0, 0.5, 0.25}}},
        {{"type", "spot"},
         {"intensity", 8.0},
         {"range", 4.0},
         {"spot", {{"outerConeAngle", 0.5}, {"innerConeAngle", 0.25}}}}};
    const double half = std::sqrt(0.5);
    glb.json["nodes"] = {
        {{"mesh", 0}, {"children", {1, 2, 3, 4, 5}}},
        {{"name", "front"}, {"camera", 0}, {"translation", {0, 1, 5}}},
        {{"name", "front"}, {"camera", 0}},
        {{"name", "plan"}, {"camera", 1}},
        {{"rotation", {-half, 0, 0, half}},
         {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
        {{"translation", {1, 2, 3}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}}};
    const ImportedScene imported = glb.import();
    ASSERT_EQ(imported.scene.cameras.size(), 2U);
    const Camera& front = imported.scene.cameras[0];
    EXPECT_EQ(front.name, "front");
    EXPECT_EQ(imported.scene.cameras[1].name, "front-2");
    expect_near(front.position_m, {0, 1, 5});
    expect_near(glm::normalize(front.target_m - front.position_m), {0, 0, -1});
    EXPECT_FLOAT_EQ(front.vertical_fov_rad, 0.7F);
    EXPECT_FLOAT_EQ(front.far_m, 50.0F);
    EXPECT_THAT(imported.notes, Contains(HasSubstr("without perspective are left out: plan")));
    ASSERT_EQ(imported.lights.size(), 1U);
    expect_near(imported.lights[0].towards_light, {0, 1, 0});  // its node looks straight down
    expect_near(imported.lights[0].irradiance, {3.0, 1.5, 0.75});
    ASSERT_EQ(imported.point_lights.size(), 1U);
    expect_near(imported.point_lights[0].position_m, {1, 2, 3});
    expect_near(imported.point_lights[0].direction, {0, 0, -1});
    EXPECT_FLOAT_EQ(imported.point_lights[0].outer_cone_rad, 0.5F);
    EXPECT_FLOAT_EQ(imported.point_lights[0].range_m, 4.0F);
}

TEST(GltfImport, AGltfFileFindsItsBuffersAndTexturesBesideItWhateverTheCaseOfTheirNames) {
    GlbMaker glb = triangle_glb();
    glb.json["images"] = {{{"uri", "Wood%20Grain.PNG"}}};
    glb.json["textures"] = {{{"source", 0}}};
    glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    glb.json["buffers"] = {{{"byteLength", glb.binary.size()}, {"uri", "tri.bin"}}};
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "tri.bin", glb.binary);
    base::write_file_atomically(folder / "wood grain.png",
                                encode_rgba_png(plain_texture(2, {1, 2, 3, 255})));
    base::write_file_atomically(folder / "tri.gltf", glb.json.dump());
    const ImportedScene imported = import_scene(folder / "tri.gltf");
    EXPECT_EQ(imported.files.size(), 3U);
    ASSERT_EQ(imported.scene.textures.size(), 1U);
    EXPECT_EQ(imported.scene.textures[0].rgba[1], 2);
}

TEST(GltfImport, WhatIsNotShownIsNoted) {
    GlbMaker glb = triangle_glb();
    glb.json["extensionsUsed"] = {"KHR_materials_variants"};
    glb.json["animations"] = {Json::object()};
    glb.json["materials"][0]["extensions"]["KHR_materials_transmission"] = Json::object();
    Json line = glb.json["meshes"][0]["primitives"][0];
    line["mode"] = 1;
    glb.json["meshes"][0]["primitives"].push_back(line);
    const auto notes = glb.import().notes;
    for (const char* what : {"KHR_materials_variants", "animations are not played",
                             "KHR_materials_transmission", "points and lines"}) {
        EXPECT_THAT(notes, Contains(HasSubstr(what)));
    }
}

}  // namespace
}  // namespace obscura::renderer
