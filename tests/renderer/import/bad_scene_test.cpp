// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "tests/renderer/import/glb_maker.h"

namespace obscura::renderer {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tests::GlbMaker;
using tests::plain_texture;
using tests::triangle_glb;
using Json = nlohmann::json;

/// What refusing the file says; empty where it is not refused as bad input.
std::string refusal_of(const GlbMaker& glb) {
    try {
        (void)glb.import();
    } catch (const base::Error& error) {
        return error.code() == base::ExitCode::kBadInput ? error.what() : "";
    }
    return "";
}

/// A change of the triangle's file and what the refusal must say.
struct BadChange {
    const char* what;
    std::function<void(Json&)> change;
    const char* fragment;
};

Json& primitive_of(Json& json) { return json["meshes"][0]["primitives"][0]; }

const std::vector<BadChange>& bad_changes() {
    static const std::vector<BadChange> list = {
        {"old version", [](Json& j) { j["asset"]["version"] = "1.0"; }, "version is \"1.0\""},
        {"no version", [](Json& j) { j.erase("asset"); }, "asset is missing"},
        {"compressed", [](Json& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "KHR_draco_mesh_compression is required"},
        {"view beyond its buffer", [](Json& j) { j["bufferViews"][0]["byteLength"] = 1000000; },
         "bufferViews[0]"},
        {"offset that wraps round",
         [](Json& j) { j["bufferViews"][0]["byteOffset"] = 18446744073709551615ULL; },
         "bufferViews[0].byteOffset"},
        {"accessor beyond its view", [](Json& j) { j["accessors"][0]["count"] = 4; },
         "accessors[0]: 4 elements"},
        {"accessor of giant count", [](Json& j) { j["accessors"][0]["count"] = 1e15; },
         "accessors[0].count"},
        {"accessor with a negative offset", [](Json& j) { j["accessors"][0]["byteOffset"] = -4; },
         "accessors[0].byteOffset: is -4"},
        {"elements that overlap", [](Json& j) { j["bufferViews"][0]["byteStride"] = 4; },
         "overlap"},
        {"unknown component", [](Json& j) { j["accessors"][0]["componentType"] = 5124; }, "5124"},
        {"unknown type", [](Json& j) { j["accessors"][0]["type"] = "VEC5"; }, "VEC5"},
        {"position of two numbers", [](Json& j) { j["accessors"][0]["type"] = "VEC2"; },
         "POSITION: its accessor has 2 components"},
        {"indices of floats", [](Json& j) { primitive_of(j)["indices"] = 0; }, "indices"},
        {"no such accessor", [](Json& j) { primitive_of(j)["indices"] = 99; },
         "indices: is 99, allowed is 0 to 3"},
        {"no positions", [](Json& j) { primitive_of(j)["attributes"].erase("POSITION"); },
         "POSITION is missing"},
        {"normals of another count", [](Json& j) { j["accessors"][1]["count"] = 2; },
         "NORMAL: has 2 elements, POSITION has 3"},
        {"no such material", [](Json& j) { primitive_of(j)["material"] = 7; }, "material: is 7"},
        {"word for a number",
         [](Json& j) {
             j["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", "big"}};
         },
         "no textures"},
        {"text for a mode", [](Json& j) { primitive_of(j)["mode"] = "triangles"; },
         "mode: is \"triangles\""},
        {"alpha mode", [](Json& j) { j["materials"][0]["alphaMode"] = "GLASS"; },
         "allowed are OPAQUE, MASK and BLEND"},
        {"own ancestor", [](Json& j) { j["nodes"][0]["children"] = {0}; }, "own ancestor"},
        {"two parents",
         [](Json& j) {
             j["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
         },
         "node 2 is a child of node 0 already"},
        {"no such node", [](Json& j) { j["scenes"][0]["nodes"] = {5}; }, "scenes[0].nodes[0]"},
        {"nodes that are a number", [](Json& j) { j["nodes"] = 3; }, "nodes: is 3"},
        {"nothing to show", [](Json& j) { j["nodes"] = {Json::object()}; }, "holds no triangles"},
        {"a thousand kilometres away",
         [](Json& j) {
             j["nodes"][0]["translation"] = {2e6, 0, 0};
         },
         "is the scale right?"},
        {"scale to infinity",
         [](Json& j) {
             j["nodes"][0]["scale"] = {1e30, 1e30, 1e30};
         },
         "vertex"},
        {"view angle",
         [](Json& j) {
             j["cameras"] = {
                 {{"type", "perspective"}, {"perspective", {{"yfov", -1}, {"znear", 0.1}}}}};
             j["nodes"][0]["camera"] = 0;
         },
         "yfov: is -1"},
        {"buffer that is missing",
         [](Json& j) {
             j["buffers"] = {{{"byteLength", 10}, {"uri", "none.bin"}}};
         },
         "none.bin: the file is missing"},
        {"buffer that is a folder",
         [](Json& j) {
             j["buffers"] = {{{"byteLength", 10}, {"uri", "."}}};
         },
         "no ordinary file"},
        {"data that is not base64",
         [](Json& j) {
             j["buffers"] = {
                 {{"byteLength", 3}, {"uri", "data:application/octet-stream;base64,a*cd"}}};
         },
         "not base64"},
    };
    return list;
}

TEST(BadScene, EachMistakeOfAGltfFileIsRefusedWithItsPlace) {
    for (const BadChange& bad : bad_changes()) {
        GlbMaker glb = triangle_glb();
        bad.change(glb.json);
        EXPECT_THAT(refusal_of(glb), HasSubstr(bad.fragment)) << bad.what;
    }
}

TEST(BadScene, AnIndexBeyondTheVerticesIsRefused) {
    GlbMaker glb = triangle_glb();
    primitive_of(glb.json)["indices"] =
        glb.add_accessor<std::uint16_t>({0, 1, 200}, "SCALAR", 5123, 3);
    EXPECT_THAT(refusal_of(glb), HasSubstr("index 2 is 200, allowed is 0 to 2"));
}

TEST(BadScene, CoordinatesThatAreNoPlaceAreRefusedByName) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float value : {std::nanf(""), kInfinity, -kInfinity, 1e38F, 1.1e6F}) {
        GlbMaker glb = triangle_glb();
        std::memcpy(glb.binary.data() + 16, &value, sizeof value);  // y of the second vertex
        EXPECT_THAT(refusal_of(glb), HasSubstr("vertex 1 lies at")) << value;
    }
}

TEST(BadScene, NormalsThatAreNoDirectionAreMadeAnew) {
    for (const float value : {std::nanf(""), std::numeric_limits<float>::infinity(), 0.0F}) {
        GlbMaker glb = triangle_glb();
        const float bad[3] = {0.0F, 0.0F, value};
        std::memcpy(glb.binary.data() + 36, bad, sizeof bad);
        const ImportedScene imported = glb.import();
        EXPECT_EQ(imported.scene.meshes[0].vertices[0].normal, glm::vec3(0.0F, 0.0F, 1.0F));
        EXPECT_THAT(imported.notes, Contains(HasSubstr("normals that are no directions")));
    }
}

TEST(BadScene, ExtensionsThatLeaveGeometryOutSayThatInTheseWords) {
    GlbMaker glb = triangle_glb();
    glb.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression",
                                  "KHR_materials_dispersion"};
    const std::vector<std::string> notes = glb.import().notes;
    EXPECT_THAT(notes, Contains(HasSubstr("geometry is left out: EXT_mesh_gpu_instancing")));
    EXPECT_THAT(notes, Contains(HasSubstr("geometry is left out: KHR_draco_mesh_compression")));
    EXPECT_THAT(notes, Contains(HasSubstr("left out: KHR_materials_dispersion")));
}

TEST(BadScene, AMeshWhosePositionsAreCompressedIsLeftOutWithANote) {
    GlbMaker glb = triangle_glb();
    Json bare = primitive_of(glb.json);
    glb.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 3}});
    bare["attributes"] = {{"POSITION", glb.json["accessors"].size() - 1}};
    glb.json["meshes"][0]["primitives"].push_back(bare);
    const ImportedScene imported = glb.import();
    EXPECT_EQ(imported.scene.triangle_count(), 1U);
    EXPECT_THAT(imported.notes,
                Contains(HasSubstr("geometry is left out: the file has no positions "
                                   "of it, or only compressed ones: meshes[0]")));
}

TEST(BadScene, ATextureThatIsMissingBecomesAMarkedCheckerboard) {
    GlbMaker glb = triangle_glb();
    glb.json["images"] = {{{"uri", "none.png"}}};
    glb.json["textures"] = {{{"source", 0}}};
    glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    glb.json["materials"][0]["normalTexture"] = {{"index", 0}};
    const ImportedScene imported = glb.import();
    EXPECT_THAT(imported.notes,
                Contains("texture none.png: the file is missing; a checkerboard stands in"));
    ASSERT_EQ(imported.scene.textures.size(), 1U);
    EXPECT_THAT(imported.scene.textures[0].name, HasSubstr("stand-in"));
    EXPECT_EQ(imported.scene.materials[0].normal_texture, kNoTexture);
}

/// The checksum of a PNG chunk (ISO 15948, annex D).
std::uint32_t crc32_of(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

TEST(BadScene, ATextureWhoseHeaderSaysTooMuchIsNotDecoded) {
    std::string png = encode_rgba_png(plain_texture(2, {1, 2, 3, 255}));
    // Width and height of the IHDR chunk, which begin at byte 16, big-endian: 65000.
    for (const std::size_t at : {16U, 20U}) {
        png[at + 2] = static_cast<char>(0xFD);
        png[at + 3] = static_cast<char>(0xE8);
    }
    const std::uint32_t crc = crc32_of(std::string_view(png).substr(12, 17));
    for (std::size_t i = 0; i < 4; ++i) {
        png[29 + i] = static_cast<char>(crc >> (24 - 8 * i) & 0xFFU);
    }
    GlbMaker glb = triangle_glb();
    const int view = glb.add_view(png.data(), png.size());
    glb.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    glb.json["textures"] = {{{"source", 0}}};
    glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const ImportedScene imported = glb.import();
    ASSERT_EQ(imported.scene.textures.size(), 1U);
    EXPECT_LE(imported.scene.textures[0].width, 64);
    EXPECT_THAT(
        imported.notes,
        Contains("texture image 0: its header says 65000x65000 texels of 3 channels, allowed "
                 "is 1 to 16384 a side; a checkerboard stands in"));
}

TEST(BadScene, ATextureCutOffAnywhereIsReplaced) {
    const std::string png = encode_rgba_png(plain_texture(16, {1, 2, 3, 255}));
    for (std::size_t length = 1; length + 12 < png.size(); length += 5) {
        GlbMaker glb = triangle_glb();
        const int view = glb.add_view(png.data(), length);
        glb.json["images"] = {{{"bufferView", view}}};
        glb.json["textures"] = {{{"source", 0}}};
        glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
        const ImportedScene imported = glb.import();
        ASSERT_EQ(imported.scene.textures.size(), 1U) << length;
    }
}

/// A file with most of what the importer reads.
std::string rich_glb() {
    GlbMaker glb = triangle_glb();
    const int texture = glb.add_image(plain_texture(4, {100, 128, 255, 200}));
    glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
    glb.json["materials"][0]["normalTexture"] = {{"index", texture}, {"scale", 0.5}};
    glb.json["materials"][0]["occlusionTexture"] = {{"index", texture}};
    Json& attributes = primitive_of(glb.json)["attributes"];
    attributes["JOINTS_0"] =
        glb.add_accessor<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 5121, 3);
    attributes["WEIGHTS_0"] = glb.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
    attributes["COLOR_0"] = glb.add_accessor<std::uint8_t>(
        {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}, "VEC4", 5121, 3);
    glb.json["skins"] = {{{"joints", {1}}}};
    glb.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
    glb.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    glb.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"children", {1}}},
                         {{"camera", 0},
                          {"scale", {1, -1, 1}},
                          {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
    return glb.bytes();
}

/// Either a sound scene or a refusal in words.
void expect_sound(const std::filesystem::path& file, const std::string& bytes) {
    tests::write_quickly(file, bytes);
    try {
        const ImportedScene imported = import_scene(file);
        ASSERT_GT(imported.scene.triangle_count(), 0U);
        for (const Mesh& mesh : imported.scene.meshes) {
            ASSERT_LT(mesh.material, imported.scene.materials.size());
            for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
            for (const Vertex& vertex : mesh.vertices) {
                ASSERT_LE(glm::length(vertex.position_m), 2e6F);
                ASSERT_NEAR(glm::length(vertex.normal), 1.0F, 0.01F);
            }
        }
    } catch (const base::Error& error) {
        ASSERT_EQ(error.code(), base::ExitCode::kBadInput) << error.what();
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

TEST(BadScene, AGlbCutOffAnywhereIsRefused) {
    const tests::TemporaryFolder folder;
    const std::string bytes = rich_glb();
    expect_sound(folder / "whole.glb", bytes);
    for (std::size_t length = 0; length < bytes.size(); length += 13) {
        tests::write_quickly(folder / "cut.glb", bytes.substr(0, length));
        EXPECT_THROW((void)import_scene(folder / "cut.glb"), base::Error) << length;
    }
}

TEST(BadScene, AGlbChangedAtRandomIsReadOrRefused) {
    const tests::TemporaryFolder folder;
    const std::string original = rich_glb();
    base::Random random(5);
    for (int i = 0; i < 600; ++i) {
        std::string bytes = original;
        for (std::uint64_t edits = 1 + random.below(4); edits > 0; --edits) {
            const std::size_t at = random.below(bytes.size());
            bytes[at] = i % 2 == 0 ? static_cast<char>(random.below(256))
                                   : static_cast<char>('0' + random.below(10));
        }
        expect_sound(folder / "changed.glb", bytes);
        if (HasFatalFailure()) FAIL() << "in round " << i;
    }
}

TEST(BadScene, JsonNestedDeepIsRefusedAndDoesNotOverflowTheStack) {
    const tests::TemporaryFolder folder;
    expect_sound(folder / "deep.gltf", std::string(200000, '['));
    expect_sound(folder / "deep.gltf", R"({"asset":{"version":"2.0"},"extras":)" +
                                           std::string(100000, '[') + std::string(100000, ']') +
                                           "}");
}

TEST(BadScene, AFileWithoutAnythingToSeeIsRefused) {
    const tests::TemporaryFolder folder;
    const auto refusal = [&](const char* name, std::string_view text) -> std::string {
        base::write_file_atomically(folder / name, text);
        try {
            (void)import_scene(folder / name);
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(refusal("empty.glb", ""), HasSubstr("it is empty"));
    EXPECT_THAT(refusal("image.glb", "\x89PNG\r\n"), HasSubstr("neither a binary glTF nor"));
    EXPECT_THAT(refusal("flat.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n"),
                HasSubstr("no triangle in it has an area"));
}

TEST(BadScene, AFileThatIsMissingOrOfAnotherKindIsRefused) {
    EXPECT_THROW((void)import_scene("/nowhere/scene.glb"), base::Error);
    EXPECT_THROW((void)import_scene("/nowhere/scene.fbx"), base::Error);
    EXPECT_THROW((void)triangle_glb().import({.scale = 0.0}), base::Error);
    EXPECT_THROW((void)triangle_glb().import({.scale = std::nan("")}), base::Error);
}

}  // namespace
}  // namespace obscura::renderer
