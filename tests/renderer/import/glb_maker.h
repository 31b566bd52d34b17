// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <glm/glm.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "renderer/base/files.h"
#include "renderer/export/png.h"
#include "renderer/import/import.h"
#include "tests/support/temporary_folder.h"

namespace obscura::tests {

/// Writes without waiting for the disk.
inline void write_quickly(const std::filesystem::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

inline void expect_near(const glm::vec3& met, const glm::vec3& expected, float tolerance = 1e-5F) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(met[i], expected[i], tolerance) << "component " << i;
}

/// A binary glTF file in the making: its JSON is free to be changed, wrong values too.
class GlbMaker {
  public:
    nlohmann::json json = {{"asset", {{"version", "2.0"}}},
                           {"scene", 0},
                           {"scenes", {{{"nodes", {0}}}}},
                           {"nodes", {{{"mesh", 0}}}}};
    std::string binary;

    /// The index of a new bufferView.
    int add_view(const void* data, std::size_t bytes) {
        binary.resize((binary.size() + 3) / 4 * 4);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes}});
        binary.append(static_cast<const char*>(data), bytes);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    template <typename T>
    int add_accessor(const std::vector<T>& values, const char* type, int component,
                     std::size_t count) {
        const int view = add_view(values.data(), values.size() * sizeof(T));
        json["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"type", type}, {"count", count}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    int add_floats(const std::vector<float>& values, const char* type, std::size_t components) {
        return add_accessor(values, type, 5126, values.size() / components);
    }
    int add_image(const renderer::Texture& texture) {
        const std::string png = renderer::encode_rgba_png(texture);
        const int view = add_view(png.data(), png.size());
        json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
        json["textures"].push_back({{"source", json["images"].size() - 1}});
        return static_cast<int>(json["textures"].size()) - 1;
    }

    [[nodiscard]] std::string bytes() const {
        nlohmann::json document = json;
        if (!binary.empty() && !document.contains("buffers")) {
            document["buffers"].push_back({{"byteLength", binary.size()}});
        }
        std::string text = document.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string padded = binary;
        padded.resize((padded.size() + 3) / 4 * 4);
        std::string glb = "glTF";
        for (const std::size_t word : {std::size_t{2}, 28 + text.size() + padded.size(),
                                       text.size(), std::size_t{0x4E4F534A}}) {
            append_word(glb, word);
        }
        glb += text;
        append_word(glb, padded.size());
        append_word(glb, 0x004E4942);
        return glb + padded;
    }
    /// Imports it from a file of the test's own.
    [[nodiscard]] renderer::ImportedScene import(
        const renderer::ImportOptions& options = {}) const {
        const TemporaryFolder folder;
        write_quickly(folder / "made.glb", bytes());
        return renderer::import_scene(folder / "made.glb", options);
    }

  private:
    static void append_word(std::string& bytes, std::size_t value) {
        const auto word = static_cast<std::uint32_t>(value);
        bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    }
};

/// One triangle (0 0 0), (1 0 0), (0 1 0) that faces +Z, with texture coordinates whose v runs
/// down.
inline GlbMaker triangle_glb() {
    GlbMaker glb;
    const int positions = glb.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    const int normals = glb.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
    const int uv = glb.add_floats({0, 1, 1, 1, 0, 0}, "VEC2", 2);
    const int indices = glb.add_accessor<std::uint16_t>({0, 1, 2}, "SCALAR", 5123, 3);
    glb.json["meshes"] = {
        {{"name", "triangle"},
         {"primitives",
          {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}}},
            {"indices", indices},
            {"material", 0}}}}}};
    glb.json["materials"] = {
        {{"name", "plain"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.0}}}}};
    return glb;
}

/// A texture of one colour.
inline renderer::Texture plain_texture(int side, std::initializer_list<int> rgba) {
    renderer::Texture texture{"plain", side, side, true, {}};
    for (int i = 0; i < side * side; ++i) {
        for (const int value : rgba) texture.rgba.push_back(static_cast<std::uint8_t>(value));
    }
    return texture;
}

}  // namespace obscura::tests
