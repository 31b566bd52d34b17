// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "renderer/import/files_read.h"
#include "renderer/import/mtl_text.h"
#include "renderer/import/mtl_texture.h"
#include "renderer/import/notes.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer::import_detail {

/// Turns the materials of Wavefront MTL files into a scene's.
///
/// Kd is taken as linear albedo; where it is not said, 1 under map_Kd and 0.8 else. Ks and Ns make
/// a Blinn-Phong highlight of that height (illum 2), which the G-buffer's normalised lobe reaches
/// with the intensity Ks * 8 / (Ns + 8). d below 1 blends, map_d cuts out; d outranks Tr. A grey
/// bump map is a height map, any other a normal map. Both sides of a surface are shown, since the
/// format knows none.
///
/// Tr alone is 1 - d to some writers and d to others. A file of which a material says Tr 1 and none
/// says Tr 0, or whose materials with both say the same in d and Tr, has it as d, since a material
/// that nobody can see can only be a mistake; any other as 1 - d. Either is noted.
class MtlReader {
  public:
    MtlReader(FilesRead& files, Notes& notes, Scene& scene)
        : files_(files), notes_(notes), scene_(scene), textures_(files, notes, scene) {}

    /// Adds the materials of the files that the rest of a mtllib statement names: one, whose name
    /// may hold blanks, or several. Each file is read once.
    void read(const std::string& names);

    /// Index in the scene. A name that no file has, but for case, quotes or a comment behind it, is
    /// taken for that one, with a note; else it is plain grey, with a note.
    [[nodiscard]] std::uint32_t material(const std::string& name);

  private:
    /// Reads the file of that name; nothing where it is not there.
    [[nodiscard]] bool read_file(const std::string& name, std::string& why);
    void say_unread(const std::string& name, const std::string& why);
    void add(const MtlMaterial& described, bool tr_is_opacity, const std::filesystem::path& folder);
    void add_opacity(const MtlMaterial& described, bool tr_is_opacity, Material& material);
    void add_maps(const MtlMaterial& described, const std::filesystem::path& folder,
                  Material& material);
    void add_highlight(const MtlMaterial& described, Material& material);
    void file_under(const std::string& name, std::uint32_t index);

    FilesRead& files_;
    Notes& notes_;
    Scene& scene_;
    MtlTextures textures_;
    std::set<std::filesystem::path> read_;
    std::map<std::string, std::uint32_t> materials_;
    std::map<std::string, std::uint32_t> alike_;      ///< by their names without case and quotes
    std::map<std::string, std::uint32_t> commented_;  ///< and by those without a comment behind
};

}  // namespace obscura::renderer::import_detail
