// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/import/obj_check.h"
#include "tests/renderer/import/obj_maker.h"

namespace obscura::renderer {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using tests::ObjMaker;

constexpr std::string_view kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string triangle(std::string_view rest) { return std::string(kCorners) + std::string(rest); }

std::vector<glm::vec3> normals_of(const ImportedScene& imported) {
    std::vector<glm::vec3> normals;
    for (const Mesh& mesh : imported.scene.meshes) {
        for (const Vertex& vertex : mesh.vertices) normals.push_back(vertex.normal);
    }
    return normals;
}

TEST(ObjStatement, NormalsThatAreNoneAreMadeAnewWithTheirPlace) {
    const ObjMaker files;
    for (const char* bad : {"nan nan nan", "-1.#IND00 -1.#IND00 -1.#IND00", "0 0 1.#QNAN", "0 0",
                            "0 0 0", "-nan(ind) 0 0", "a b c", "inf 0 0", ""}) {
        const ImportedScene imported = files.import(
            triangle(fmt::format("vn 0 0 1\nvn {}\nf 1//1 2//1 3//1\nf 1//2 3//2 2//2\n", bad)));
        EXPECT_EQ(imported.scene.triangle_count(), 2U) << bad;
        EXPECT_THAT(normals_of(imported),
                    AllOf(Contains(glm::vec3(0, 0, 1)), Contains(glm::vec3(0, 0, -1))))
            << bad;
        EXPECT_THAT(imported.notes, Contains(AllOf(HasSubstr("vn wants three finite numbers"),
                                                   HasSubstr("made.obj:5 (vn"))))
            << bad;
        EXPECT_THAT(imported.notes, Contains(HasSubstr("1 of 2"))) << bad;
    }
}

TEST(ObjStatement, IndicesOfNormalsAndTextureCoordinatesThatAreNotThereAreNoneAndSaid) {
    const ObjMaker files;
    const ImportedScene imported = files.import(triangle("f 1/1/1 2/2/2 3/3/-1\n"));
    EXPECT_THAT(normals_of(imported), Each(glm::vec3(0, 0, 1)));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("a vn that is not there (the file has 0)")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("a vt that is not there (the file has 0)")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("made.obj:4")));
    EXPECT_THAT(imported.notes, Each(Not(HasSubstr("1 to 0"))));
    // Each face counts once.
    std::string many(kCorners);
    for (int i = 0; i < 10; ++i) many += "f 1//1 2//2 3//3\n";
    EXPECT_THAT(files.import(many).notes, Contains(HasSubstr("made.obj:9 and 4 more")));
}

TEST(ObjStatement, TextureCoordinatesThatAreNoneAreZeroWithTheirPlace) {
    const ObjMaker files;
    const ImportedScene imported =
        files.import(triangle("vt nan nan\nvt 0.5\nvt 1 1 0\nf 1/1 2/2 3\n"));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("made.obj:4 (vt nan nan)")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("some corners have a vt get 0 0")));
    for (const Vertex& vertex : imported.scene.meshes[0].vertices) {
        EXPECT_EQ(vertex.uv, glm::vec2(vertex.position_m.x > 0.5F ? 0.5F : 0.0F, 1.0F));
    }
}

TEST(ObjStatement, StatementsThatAreNotShownAreGatheredWithTheirFirstPlaces) {
    const ObjMaker files;
    std::string text = triangle("f 1 2 3\nl 1 2\np 1\nfoo bar\ncstype bezier\ncurv 0 1 1 2 3\n");
    for (int i = 0; i < 100; ++i) text += "l 2 3\n";
    const std::vector<std::string> notes = files.import(text).notes;
    EXPECT_THAT(notes,
                Contains(AllOf(HasSubstr("lines and points are left out: made.obj:5 (l 1 2)"),
                               HasSubstr("and 96 more"))));
    EXPECT_THAT(notes, Contains(HasSubstr("not known are passed over: made.obj:7 (foo bar)")));
    EXPECT_THAT(notes, Contains(HasSubstr("curves and surfaces are left out")));
}

TEST(ObjStatement, StatementsHaveNoOrder) {
    const ObjMaker files;
    files.add("made.mtl", "newmtl red\nKd 1 0 0\n");
    const ImportedScene imported =
        files.import("usemtl red\nf 1 2 3\n" + std::string(kCorners) + "mtllib made.mtl\n");
    EXPECT_EQ(tests::first_material(imported).albedo, glm::vec3(1, 0, 0));
    EXPECT_EQ(imported.scene.triangle_count(), 1U);
}

TEST(ObjStatement, EveryKindOfLineEndIsRead) {
    const ObjMaker files;
    const std::string unix_text = triangle("usemtl a \\\nf 1 2 \\\n3 # a face\nf 3 2 \\\n 1\n");
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string text;
        for (const char c : unix_text) text += c == '\n' ? std::string(end) : std::string(1, c);
        const ImportedScene imported = files.import("\xEF\xBB\xBF# mark\n" + text);
        EXPECT_EQ(imported.scene.triangle_count(), 2U);
        EXPECT_EQ(tests::first_material(imported).name, "a \\");
    }
}

TEST(ObjStatement, ACommentEndsWithItsLineEvenBehindABackslash) {
    const ObjMaker files;
    EXPECT_EQ(
        files.import("# from C:\\models\\\n" + triangle("f 1 2 3#x\n")).scene.triangle_count(), 1U);
}

TEST(ObjStatement, ColoursOfVerticesAreReadAndWhatElseStandsThereIsSaid) {
    const ObjMaker files;
    const ImportedScene imported = files.import(
        "v 0 0 0 1 0 0\nv 1 0 0 nan 0 0\nv 0 1 0 1\nv 1 1 0 2\nv 2 2 0 0 1 0 1\nf 1 2 3\nf 2 4 "
        "5\n");
    const auto colour_at = [&](const glm::vec3& place) {
        for (const Vertex& v : imported.scene.meshes[0].vertices) {
            if (v.position_m == place) return v.color;
        }
        return glm::u8vec4(0);
    };
    EXPECT_EQ(colour_at({0, 0, 0}), glm::u8vec4(255, 0, 0, 255));
    EXPECT_EQ(colour_at({1, 0, 0}), glm::u8vec4(255));
    EXPECT_EQ(colour_at({2, 2, 0}), glm::u8vec4(0, 255, 0, 255));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("white stands in: made.obj:2")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("no colour are left out: made.obj:4")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("behind the colour of a vertex")));
}

TEST(ObjStatement, BothSidesAreShownAndTrianglesFollowTheirNormals) {
    const ObjMaker files;
    const ImportedScene plain = files.import(triangle("f 1 2 3\n"));
    EXPECT_TRUE(tests::first_material(plain).double_sided);
    EXPECT_FALSE(plain.has_sides);
    // Wound against its normal: seen from where the normal points, it is the front.
    const ImportedScene against = files.import(triangle("vn 0 0 1\nf 1//1 3//1 2//1\n"));
    const Mesh& mesh = against.scene.meshes[0];
    const auto at = [&mesh](std::size_t i) { return mesh.vertices[mesh.indices[i]].position_m; };
    EXPECT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).z, 0.0F);
    EXPECT_THAT(against.notes, Contains(HasSubstr("turned over: 1 of 1")));
}

TEST(ObjStatement, TheTextThatIsLeftIsSoundAndTheSameWhenItIsCheckedAgain) {
    import_detail::Notes notes;
    const std::string text = triangle(
        "vn 0 0 1\nvn x\nvt 1 nan\nusemtl a b\nf 1/1/1 2/1/2 3\nusemtl c\nf 1//1 2//1 3//1\n"
        "usemtl a b\nf 3//1 2//1 1//1\n");
    const import_detail::CheckedObj once = import_detail::check_obj(text, "x.obj", notes);
    EXPECT_THAT(once.materials, ElementsAre("a b", "c", "a b"));
    EXPECT_EQ(import_detail::check_obj(once.text, "x.obj", notes).text, once.text);
}

TEST(ObjStatement, AnOrdinaryFileHasNoNote) {
    const ObjMaker files;
    files.add("made.mtl",
              "newmtl m\nKa 0 0 0\nKd .5 .5 .5\nKs 0 0 0\nNs 10\nd 1\nillum 2\nNi 1.5\n");
    const ImportedScene imported =
        files.import("mtllib made.mtl\no thing\ng a\ns off\n" +
                     triangle("vn 0 0 1\nvt 0 0\nusemtl m\nf 1/1/1 2/1/1 3/1/1\n"));
    EXPECT_THAT(imported.notes, IsEmpty());
}

}  // namespace
}  // namespace obscura::renderer
