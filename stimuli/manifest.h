// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/accuracy.h"
#include "stimuli/image_difference.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// How scene light became display light; no operator: values above 1 were clipped.
struct ManifestToneMapping {
    std::string curve;  ///< reinhard, filmic, aces or clip; empty: none
    double exposure = 1.0;
    double white = 1.0;
};

/// One stimulus image as it was made.
struct ManifestImage {
    std::string file;    ///< relative to the manifest's folder, CONDITION-a.png
    std::string sha256;  ///< of the file's bytes
    std::string condition;
    std::string side;    ///< a or b
    std::string scene;   ///< id in the study
    std::string source;  ///< the scene that it is
    std::string camera;
    std::string validity;
    std::string settings = "{}";  ///< what the study says of the scene beyond that, as JSON
    /// A file that the scene is made of: its name and the SHA-256 of its bytes.
    struct SceneFile {
        std::string name;
        std::string sha256;
    };
    std::vector<SceneFile> scene_files;    ///< none for a built-in scene
    std::vector<std::string> scene_notes;  ///< what of them is not shown, or replaced
    renderer::Variant variant;  ///< written with every parameter, those at their default too
    int width = 0;
    int height = 0;
    int supersampling = 1;
    std::optional<float> occluding_opacity;  ///< nothing: no blended surface occludes
    ManifestToneMapping tone_mapping;
    std::vector<std::string> passes;
    /// Of all passes when it was made, compiling shaders included; surfaces, shadow maps and light
    /// that several images share count for each of them.
    double milliseconds = 0.0;
    /// Of the image's pixels, as a share of display white (IEC 61966-2-1); nothing: not measured.
    std::optional<double> mean_luminance;
    std::optional<double> contrast;  ///< as Brightness has it; nothing: not measured
    /// Of an image that is made as bright as the other one of its pair: what its light was
    /// multiplied by before the tone curve. Nothing: it was left as it is.
    std::optional<double> exposure_factor;
    /// 1 less the mean accessibility, after its filter, over the whole image; nothing: not
    /// measured, or a technique that makes colour.
    std::optional<double> mean_occlusion;
    /// Against the truth of its pair; nothing: not measured, no radius to ask for, or a technique
    /// that makes colour.
    std::optional<Accuracy> accuracy;
    std::string
        inputs_sha256;  ///< of all that the image depends on; the same inputs, the same image
};

/// How far the two images of a condition are apart.
struct ManifestPair {
    std::string condition;
    std::string a_sha256;  ///< of the images that were compared
    std::string b_sha256;
    ImageDifference difference;
    std::string reason;  ///< the likely one where nobody could see a difference; empty: not known

    bool operator==(const ManifestPair&) const = default;
};

/// `manifest.json` of a study's folder of stimuli.
struct Manifest {
    std::string study;
    std::uint64_t seed = 0;
    std::string gpu_renderer;
    std::vector<ManifestImage> images;
    std::vector<ManifestPair> pairs = {};  ///< of which both images were finished

    /// The entry of that condition and side ("a" or "b"), or nullptr.
    [[nodiscard]] const ManifestImage* find(const std::string& condition,
                                            const std::string& side) const;
};

/// The side ('a' or 'b') whose error is smaller by kLeastOrder or more of the other's; 0: neither,
/// or not measured.
[[nodiscard]] char more_accurate(const ManifestImage& a, const ManifestImage& b);

/// Reads manifest.json. Throws bad input naming the file and what is wrong in it.
[[nodiscard]] Manifest load_manifest(const std::filesystem::path& file);

/// Writes it atomically, images ordered as given.
void save_manifest(const std::filesystem::path& file, const Manifest& manifest);

/// DATA/stimuli/STUDY
[[nodiscard]] std::filesystem::path stimuli_folder(const std::filesystem::path& data,
                                                   const Study& study);

/// Whether the image shows what the study asks of its condition and side: scene, camera, validity,
/// settings, size and variant.
[[nodiscard]] bool shows_what_is_asked(const Study& study, const ManifestImage& image);

/// Everything that keeps a study from being shown, a sentence each naming the file: no manifest,
/// an image missing, its bytes not those of the manifest (SHA-256), its size not the study's, or
/// made from another scene, camera, validity, technique or parameter than the study now asks for.
/// Empty when every image of the study is ready.
[[nodiscard]] std::vector<std::string> problems_of_stimuli(const Study& study,
                                                           const std::filesystem::path& folder);

}  // namespace obscura::stimuli
