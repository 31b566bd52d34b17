// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "renderer/base/error.h"
#include "tests/renderer/import/glb_maker.h"

namespace obscura::tests {

/// An OBJ file with the files that it names, in a folder of the test's own.
class ObjMaker {
  public:
    /// A square of 2 m that faces +Z, of the material `m`; its MTL file is made.mtl.
    static constexpr std::string_view kSquare =
        "mtllib made.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "usemtl m\nf 1/1 2/2 3/3 4/4\n";

    void add(const std::string& name, std::string_view bytes) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        write_quickly(folder_ / name, bytes);
    }
    void add(const std::string& name, const renderer::Texture& texture) const {
        add(name, renderer::encode_rgba_png(texture));
    }
    [[nodiscard]] renderer::ImportedScene import(
        std::string_view obj = kSquare, const renderer::ImportOptions& options = {}) const {
        add("made.obj", obj);
        return renderer::import_scene(folder_ / "made.obj", options);
    }
    /// The square with this text as its MTL file.
    [[nodiscard]] renderer::ImportedScene with_materials(std::string_view mtl) const {
        add("made.mtl", mtl);
        return import();
    }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return folder_ / name;
    }

  private:
    TemporaryFolder folder_;
};

/// The material of the first mesh.
inline const renderer::Material& first_material(const renderer::ImportedScene& imported) {
    return imported.scene.materials.at(imported.scene.meshes.at(0).material);
}

/// The first texel of a material's colours.
inline std::vector<int> first_texel(const renderer::ImportedScene& imported) {
    const auto& rgba = imported.scene.textures
                           .at(static_cast<std::size_t>(first_material(imported).albedo_texture))
                           .rgba;
    return {rgba.begin(), rgba.begin() + 4};
}

}  // namespace obscura::tests
