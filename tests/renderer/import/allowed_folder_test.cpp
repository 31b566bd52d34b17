// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "tests/renderer/import/obj_maker.h"

namespace obscura::renderer {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using tests::plain_texture;

const char* const kSaid = "outside the scene's folder and is not read; --allow FOLDER";

/// A folder `scene` beside another one, `private`, with a texture, materials and a buffer in it.
class AllowedFolder : public testing::Test {
  protected:
    void SetUp() override {
        files_.add("private/secret.png", plain_texture(2, {9, 8, 7, 255}));
        files_.add("private/secret.mtl", "newmtl m\nKd 1 0 0\n");
        const std::string glb = tests::triangle_glb().binary;
        files_.add("private/secret.bin", glb);
        files_.add("scene/own/own.png", plain_texture(2, {1, 2, 3, 255}));
        std::filesystem::create_symlink(files_ / "private/secret.png", files_ / "scene/link.png");
        std::filesystem::create_directory_symlink(files_ / "private", files_ / "scene/door");
    }

    [[nodiscard]] ImportedScene obj(std::string_view mtl, const ImportOptions& options = {}) const {
        files_.add("scene/own/made.mtl", mtl);
        files_.add("scene/made.obj",
                   "mtllib own/made.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
        return import_scene(files_ / "scene/made.obj", options);
    }
    /// A glTF file whose buffer, and a texture, are those of that URI.
    [[nodiscard]] ImportedScene gltf(const std::string& buffer, const std::string& image,
                                     const ImportOptions& options = {}) const {
        tests::GlbMaker glb = tests::triangle_glb();
        glb.json["buffers"] = {{{"byteLength", glb.binary.size()}, {"uri", buffer}}};
        glb.json["images"] = {{{"uri", image}}};
        glb.json["textures"] = {{{"source", 0}}};
        glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
        files_.add("scene/own.bin", glb.binary);
        files_.add("scene/made.gltf", glb.json.dump());
        return import_scene(files_ / "scene/made.gltf", options);
    }
    [[nodiscard]] ImportOptions allowed() const {
        return {.allowed_folders = {files_ / "private"}};
    }
    [[nodiscard]] std::vector<std::string> ways_out(const std::string& file,
                                                    const std::string& up) const {
        return {up + "private/" + file, up + "scene/door/" + file,
                (files_ / ("private/" + file)).string()};
    }

    tests::ObjMaker files_;
};

TEST_F(AllowedFolder, ATextureOutsideIsReplacedUnlessItsFolderIsAllowed) {
    std::vector<std::string> names = ways_out("secret.png", "../../");
    names.insert(names.end(), {"..\\..\\private\\secret.png", "../link.png", "../door/secret.png",
                               "../../PRIVATE/secret.png", "../nowhere/../../private/secret.png"});
    for (const std::string& name : names) {
        const std::string mtl = fmt::format("newmtl m\nmap_Kd {}\n", name);
        const ImportedScene imported = obj(mtl);
        EXPECT_THAT(imported.notes, Contains(HasSubstr(kSaid))) << name;
        EXPECT_EQ(tests::first_texel(imported)[1], 0) << "the checkerboard's magenta";
        EXPECT_EQ(imported.files.size(), 2U) << name;
        if (name.find("PRIVATE") != std::string::npos || name.find("nowhere") < name.size())
            continue;
        EXPECT_THAT(tests::first_texel(obj(mtl, allowed())), testing::ElementsAre(9, 8, 7, 255))
            << name;
    }
    // Up and down again within the scene's folder is no way out.
    for (const char* own : {"own.png", "../own/own.png", "../../scene/own/own.png"}) {
        const ImportedScene imported = obj(fmt::format("newmtl m\nmap_Kd {}\n", own));
        EXPECT_THAT(tests::first_texel(imported), testing::ElementsAre(1, 2, 3, 255)) << own;
    }
}

TEST_F(AllowedFolder, MasksHeightMapsAndMaterialsOutsideAreNotReadEither) {
    const ImportedScene imported =
        obj("newmtl m\nmap_d ../link.png\nbump ../link.png\nnorm ../../private/secret.png\n"
            "map_Ke ../link.png\n");
    EXPECT_TRUE(imported.scene.textures.empty());
    EXPECT_EQ(imported.files.size(), 2U);
    for (const std::string& name : ways_out("secret.mtl", "../")) {
        files_.add("scene/made.obj",
                   "mtllib " + name + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
        const ImportedScene grey = import_scene(files_ / "scene/made.obj");
        EXPECT_EQ(tests::first_material(grey).albedo, glm::vec3(0.8F)) << name;
        EXPECT_THAT(grey.notes, Contains(HasSubstr(kSaid))) << name;
        const ImportedScene red = import_scene(files_ / "scene/made.obj", allowed());
        EXPECT_EQ(tests::first_material(red).albedo, glm::vec3(1, 0, 0)) << name;
    }
}

TEST_F(AllowedFolder, ABufferOutsideIsRefusedWithTheOptionThatAllowsIt) {
    const std::string absolute = (files_ / "private/secret.bin").string();
    for (const std::string& uri :
         {std::string("../private/secret.bin"), std::string("%2e%2e/private/secret.bin"),
          std::string("..%2Fprivate%2fsecret.bin"), std::string("door/secret.bin"), absolute,
          "file://" + absolute, "file://localhost" + absolute, "FILE:" + absolute}) {
        try {
            (void)gltf(uri, "own/own.png");
            ADD_FAILURE() << uri;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            EXPECT_THAT(error.what(), HasSubstr(kSaid)) << uri;
        }
        EXPECT_EQ(gltf(uri, "own/own.png", allowed()).scene.triangle_count(), 1U) << uri;
    }
}

TEST_F(AllowedFolder, AnImageOfAGltfFileOutsideIsReplaced) {
    for (const char* uri : {"../private/secret.png", "%2e%2e/private/secret.png", "link.png"}) {
        const ImportedScene imported = gltf("own.bin", uri);
        EXPECT_THAT(imported.notes, Contains(HasSubstr(kSaid))) << uri;
        EXPECT_EQ(tests::first_texel(imported)[1], 0) << uri;
        EXPECT_THAT(tests::first_texel(gltf("own.bin", uri, allowed())),
                    testing::ElementsAre(9, 8, 7, 255))
            << uri;
    }
    EXPECT_THAT(gltf("own.bin", "own/own.png").notes, Each(Not(HasSubstr("outside"))));
    EXPECT_THAT(gltf("own.bin", "https://example.org/a.png").notes,
                Contains(HasSubstr("not on this machine")));
}

TEST_F(AllowedFolder, TheSceneItselfMayBeALinkAndItsFolderToo) {
    (void)obj("newmtl m\nmap_Kd own.png\n");
    std::filesystem::create_directory_symlink(files_ / "scene", files_ / "short");
    const ImportedScene imported = import_scene(files_ / "short/made.obj");
    EXPECT_THAT(tests::first_texel(imported), testing::ElementsAre(1, 2, 3, 255));
    std::filesystem::create_symlink(files_ / "scene/made.obj", files_ / "private/made.obj");
    const ImportedScene elsewhere = import_scene(files_ / "private/made.obj");
    EXPECT_THAT(elsewhere.notes, Contains(HasSubstr("own/made.mtl: the file is missing")));
}

}  // namespace
}  // namespace obscura::renderer
