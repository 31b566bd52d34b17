// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/tally.h"

namespace obscura::analysis {

/// One image of a condition, as the program that made it describes it.
struct ShownImage {
    std::string condition;
    char side = 'A';            ///< A or B
    std::string scene_id = {};  ///< the study's name of it; empty: not said
    std::string scene;
    std::string camera;
    std::string validity;
    std::string technique;
    std::string variant;  ///< as in the votes: Blizzard24, with what differs behind it
    int samples = 0;
    std::map<std::string, double> parameters;  ///< every one of the technique's
    std::string denoise;
    std::string depth_format = "r32f";
    std::optional<double> mean_luminance = {};   ///< share of display white; nothing: not known
    std::optional<double> mean_occlusion = {};   ///< over the whole image, [0, 1]
    std::optional<double> contrast = {};         ///< standard deviation of luminance over its mean
    std::optional<double> exposure_factor = {};  ///< of an image made as bright as its pair's other
    std::optional<double> rmse = {};             ///< of its accessibility against the truth
    /// Share of its pixels that differ noticeably from the other image of its pair.
    std::optional<double> noticeable_share = {};
    std::filesystem::path file;  ///< empty: there is no image file
    std::string sha256;          ///< of the file when it was made
};

/// The one of the images that shows the condition's variant of that side ('A' or 'B'), or nullptr.
/// Names of before they said what differs, technique and samples only, are known too.
[[nodiscard]] const ShownImage* shown_image(const std::vector<ShownImage>& images,
                                            const ConditionVotes& condition, char side);

}  // namespace obscura::analysis
