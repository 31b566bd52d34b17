// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "renderer/import/files_read.h"
#include "renderer/import/image.h"
#include "renderer/import/notes.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer::import_detail {

/// Reads Wavefront MTL texts into a scene's materials. Kd is taken as linear albedo; Ks and Ns as
/// a Blinn-Phong highlight of that height (illum 2), which the G-buffer's normalised lobe reaches
/// with the intensity Ks * 8 / (Ns + 8); d below 1 blends, map_d cuts out; a grey bump map is a
/// height map, any other a normal map.
class MtlReader {
  public:
    MtlReader(FilesRead& files, Notes& notes, Scene& scene)
        : files_(files), notes_(notes), scene_(scene) {}

    /// Adds the materials of a file, whose name is relative to the scene's folder. Throws bad input
    /// naming file and line for a number that is none.
    void read(const std::string& file);

    /// Index in the scene; a plain grey one, with a note, where the name is not known.
    [[nodiscard]] std::uint32_t material(const std::string& name);

  private:
    struct Place {
        const std::string& file;
        int line;
    };
    void statement(const std::vector<std::string_view>& words, std::string_view line,
                   const Place& place, Material& material);
    void map(const std::vector<std::string_view>& words, std::string_view line, const Place& place,
             Material& material);
    [[nodiscard]] TextureIndex texture(const std::string& file, bool srgb, bool stands_in);
    [[nodiscard]] TextureIndex bump(const std::string& file, double strength);
    void cut_out(const std::string& file, Material& material);

    FilesRead& files_;
    Notes& notes_;
    Scene& scene_;
    ImageDecoder decoder_;
    std::map<std::string, std::uint32_t> materials_;
    std::map<std::string, TextureIndex> textures_;
};

}  // namespace obscura::renderer::import_detail
