// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "tests/renderer/import/glb_maker.h"

namespace obscura::renderer {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tests::plain_texture;
using tests::TemporaryFolder;

constexpr std::string_view kQuad = R"(# a square that faces +Z
mtllib square.mtl
v 0 0 0
v 2 0 0
v 2 2 0
v 0 2 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
usemtl painted wood
f 1/1/1 2/2/1 3/3/1 4/4/1
usemtl plain
f -4/-4/-1 -3/-3/-1 -2/-2/-1
)";

constexpr std::string_view kMaterials = R"(newmtl painted wood
Kd 0.5 0.25 0.125
Ks 0.5 0.5 0.5
Ns 8
map_Kd -s 1 1 1 textures\Wood.png
map_d holes.png
newmtl plain
Kd 1 1 1
d 0.25
)";

ImportedScene import_text(const TemporaryFolder& folder, std::string_view text,
                          const ImportOptions& options = {}) {
    tests::write_quickly(folder / "square.obj", text);
    return import_scene(folder / "square.obj", options);
}

std::string refusal_of_obj(std::string_view text) {
    const TemporaryFolder folder;
    try {
        (void)import_text(folder, text);
    } catch (const base::Error& error) {
        return error.code() == base::ExitCode::kBadInput ? error.what() : "";
    }
    return "";
}

TEST(ObjImport, ReadsPolygonsMaterialsAndTextures) {
    const TemporaryFolder folder;
    base::write_file_atomically(folder / "square.mtl", kMaterials);
    base::write_file_atomically(folder / "textures/wood.png",
                                encode_rgba_png(plain_texture(2, {9, 8, 7, 255})));
    base::write_file_atomically(folder / "holes.png",
                                encode_rgba_png(plain_texture(2, {64, 64, 64, 255})));
    const ImportedScene imported = import_text(folder, kQuad, {.scale = 0.5});
    const Scene& scene = imported.scene;
    ASSERT_EQ(scene.meshes.size(), 2U);
    const Mesh& square = scene.meshes[0];
    EXPECT_EQ(square.indices.size(), 6U);
    EXPECT_EQ(square.vertices.size(), 4U);
    const Material& wood = scene.materials[square.material];
    EXPECT_EQ(wood.name, "painted wood");
    EXPECT_EQ(wood.albedo, glm::vec3(0.5F, 0.25F, 0.125F));
    EXPECT_FLOAT_EQ(wood.specular_power, 8.0F);
    EXPECT_FLOAT_EQ(wood.specular_intensity, 0.25F);  // 0.5 * 8 / (8 + 8)
    EXPECT_EQ(wood.coverage, Coverage::kCutOut);
    const Texture& texture = scene.textures[static_cast<std::size_t>(wood.albedo_texture)];
    EXPECT_EQ(texture.rgba[0], 9);
    EXPECT_EQ(texture.rgba[3], 64);
    const Material& plain = scene.materials[scene.meshes[1].material];
    EXPECT_EQ(plain.coverage, Coverage::kBlended);
    EXPECT_FLOAT_EQ(plain.opacity, 0.25F);
    float farthest = 0.0F;
    for (const Vertex& vertex : square.vertices) {
        EXPECT_EQ(vertex.normal, glm::vec3(0.0F, 0.0F, 1.0F));
        // The image's lower border is v = 1 here.
        EXPECT_FLOAT_EQ(vertex.uv.y, 1.0F - vertex.position_m.y);
        farthest = std::max(farthest, vertex.position_m.x);
    }
    EXPECT_FLOAT_EQ(farthest, 1.0F);  // half of 2
    EXPECT_EQ(imported.files.size(), 4U);
}

TEST(ObjImport, MissingMaterialsAndTexturesAreReplacedAndNoted) {
    const TemporaryFolder folder;
    EXPECT_THAT(import_text(folder, kQuad).notes, Contains(HasSubstr("square.mtl: the file is")));
    base::write_file_atomically(folder / "square.mtl", kMaterials);
    const ImportedScene imported = import_text(folder, kQuad);
    EXPECT_THAT(imported.notes, Contains(HasSubstr("a checkerboard stands in")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("holes.png: the file is missing")));
}

TEST(ObjImport, MissingNormalsAreSmoothOnlyWhereTheSurfaceIs) {
    // Two squares that meet in a right angle, and share an edge.
    const TemporaryFolder folder;
    const ImportedScene imported = import_text(folder,
                                               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                                               "v 0 1 1\nf 1 2 3 4\nf 5 1 4 6\n");
    for (const Mesh& mesh : imported.scene.meshes) {
        for (const Vertex& vertex : mesh.vertices) {
            EXPECT_NEAR(std::max(std::abs(vertex.normal.x), std::abs(vertex.normal.z)), 1.0F,
                        1e-5F);
        }
    }
    EXPECT_THAT(imported.notes, Contains(HasSubstr("smooth ones")));
}

TEST(ObjImport, AHeightMapBecomesNormalsThatLeanDownhill) {
    const TemporaryFolder folder;
    Texture ramp = plain_texture(8, {0, 0, 0, 255});
    for (int i = 0; i < 64; ++i) {
        for (int c = 0; c < 3; ++c) {
            ramp.rgba[static_cast<std::size_t>(4 * i + c)] = static_cast<std::uint8_t>(i % 8 * 30);
        }
    }
    base::write_file_atomically(folder / "ramp.png", encode_rgba_png(ramp));
    base::write_file_atomically(folder / "square.mtl", "newmtl painted wood\nbump ramp.png\n");
    const ImportedScene imported = import_text(folder, kQuad);
    ASSERT_EQ(imported.scene.textures.size(), 1U);
    const std::vector<std::uint8_t>& normals = imported.scene.textures[0].rgba;
    EXPECT_LT(normals[4 * 3], 110);           // it rises along u: x points back
    EXPECT_NEAR(normals[4 * 3 + 1], 128, 1);  // and is level along v
    EXPECT_FALSE(imported.scene.textures[0].srgb);
}

TEST(ObjImport, EachMistakeIsRefusedAtItsLine) {
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 3\n"),
                HasSubstr("square.obj:3: "));
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nv 0 1 1e38\nf 1 2 3\n"), HasSubstr(":3: "));
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nv 0 1 1e20\nf 1 2 3\n"),
                HasSubstr("scale right"));
    EXPECT_THAT(refusal_of_obj("v 0 0\n"), HasSubstr(":1: \"v 0 0\": a position wants three"));
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
                HasSubstr(":4: \"4\" is no index of a vertex"));
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n"),
                HasSubstr("from 1 on, or from -1 to -3"));
    EXPECT_THAT(refusal_of_obj("f 1 2 -1\nv 0 0 0\n"),
                testing::EndsWith("wanted is a number from 1 on"));
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nf 1 2\n"), HasSubstr("a face of 2 corners"));
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"),
                HasSubstr("\"0\" is no index"));
    EXPECT_THAT(refusal_of_obj(""), HasSubstr("no faces"));
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n"), HasSubstr("no faces"));
}

TEST(ObjImport, ATextCutOffOrChangedAnywhereIsReadOrRefused) {
    const TemporaryFolder folder;
    base::write_file_atomically(folder / "textures/wood.png",
                                encode_rgba_png(plain_texture(2, {9, 8, 7, 255})));
    const auto try_both = [&](std::string_view obj, std::string_view mtl) {
        tests::write_quickly(folder / "square.mtl", mtl);
        try {
            EXPECT_GT(import_text(folder, obj).scene.triangle_count(), 0U);
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput) << error.what();
        }
    };
    for (std::size_t length = 0; length < kQuad.size(); length += 7) {
        try_both(kQuad.substr(0, length), kMaterials);
    }
    base::Random random(11);
    const std::string_view alphabet = "/-.#\\\n 0159vftnxK";
    for (int i = 0; i < 200; ++i) {
        std::string obj(kQuad);
        std::string mtl(kMaterials);
        for (int edits = 0; edits < 3; ++edits) {
            obj[random.below(obj.size())] = alphabet[random.below(alphabet.size())];
            mtl[random.below(mtl.size())] = alphabet[random.below(alphabet.size())];
        }
        try_both(obj, mtl);
    }
}

}  // namespace
}  // namespace obscura::renderer
