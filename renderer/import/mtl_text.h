// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/import/notes.h"
#include "renderer/import/obj_text.h"

namespace obscura::renderer::import_detail {

/// What of an image is its one value (-imfchan).
enum class ImageChannel { kRed, kGreen, kBlue, kMatte, kLuminance };

/// A texture as a material names it.
struct MtlMap {
    std::vector<std::string> names;  ///< how its file may be called, the likeliest first; none: it
                                     ///< names no file
    double strength = 1.0;           ///< -bm
    std::optional<ImageChannel> channel;  ///< -imfchan, where it says
    std::string place;                    ///< FILE:LINE
};

/// A material as the file describes it: what it does not say is not there.
struct MtlMaterial {
    std::string name;                     ///< all that follows newmtl
    std::optional<glm::vec3> kd, ks, ke;  ///< as the file has them, but none below 0
    std::optional<double> ns;
    std::optional<double> d, tr;  ///< [0, 1]
    std::optional<int> illum;
    std::optional<MtlMap> map_kd, map_ke, map_d, bump, norm;
    std::string map_ka;  ///< where one stands
};

/// Reads a Wavefront MTL text. Statements have no order; of one that is there twice the last
/// counts. What cannot be used is passed over, with a note that names `file`, line, statement and
/// what it wants.
[[nodiscard]] std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& file,
                                                Notes& notes);

/// The file that a map statement names, with its options. Of these -bm and -imfchan are obeyed
/// where `scalar` says that the image is one value a texel; each that is not gets a note.
[[nodiscard]] MtlMap read_map(const ObjLine& line, const std::string& place, bool scalar,
                              Notes& notes);

}  // namespace obscura::renderer::import_detail
