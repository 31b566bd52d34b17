// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "renderer/import/files_read.h"
#include "renderer/import/image.h"
#include "renderer/import/mtl_text.h"
#include "renderer/import/notes.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer::import_detail {

/// The textures that materials of MTL files name, each image decoded once for a use. A file's name
/// is relative to the MTL file's `folder`, which is relative to the scene's.
class MtlTextures {
  public:
    MtlTextures(FilesRead& files, Notes& notes, Scene& scene)
        : files_(files), notes_(notes), scene_(scene) {}

    /// Index of a texture of colours without alpha. What cannot be read becomes a checkerboard
    /// where `stands_in` says so, else kNoTexture, with a note.
    [[nodiscard]] TextureIndex colour(const MtlMap& map, const std::filesystem::path& folder,
                                      bool stands_in);
    /// Whether the image of that texture had an alpha that says something.
    [[nodiscard]] bool had_alpha(TextureIndex colour) const { return had_alpha_.contains(colour); }

    /// Index of a normal map; a grey bump map is a height map and becomes one.
    [[nodiscard]] TextureIndex normals(const MtlMap& map, const std::filesystem::path& folder,
                                       bool may_be_heights);

    /// The colours of a texture, white for kNoTexture, with the image's scalar as their alpha: its
    /// alpha channel, else its luminance, else what -imfchan says. `map_kd` is what the colours are
    /// of. Nothing, with a note, where the mask cannot be read; the colours themselves where it
    /// hides nothing.
    [[nodiscard]] std::optional<TextureIndex> cut_out(TextureIndex colour, const MtlMap& mask,
                                                      const std::optional<MtlMap>& map_kd,
                                                      const std::filesystem::path& folder);

  private:
    [[nodiscard]] std::optional<FoundFile> find(const MtlMap& map,
                                                const std::filesystem::path& folder,
                                                std::string& why);
    [[nodiscard]] std::optional<DecodedImage> decode(const FoundFile& file, const MtlMap& map,
                                                     bool srgb, std::string& why);
    [[nodiscard]] ImageChannel channel_of(const MtlMap& mask, const DecodedImage& image,
                                          bool is_of_colours);
    TextureIndex add(const std::string& key, Texture&& texture);

    FilesRead& files_;
    Notes& notes_;
    Scene& scene_;
    ImageDecoder decoder_;
    std::map<std::string, TextureIndex> known_;  ///< by file, use and options
    std::set<TextureIndex> had_alpha_;
};

}  // namespace obscura::renderer::import_detail
