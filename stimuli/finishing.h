// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <future>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/progress.h"
#include "stimuli/manifest.h"
#include "stimuli/pairs.h"
#include "stimuli/stimulus.h"

namespace obscura::stimuli {

/// manifest-K-of-N.json, the list of a part.
[[nodiscard]] bool is_part_manifest(std::string_view name);

/// A finished image, and whether this program would make it from the same inputs today.
struct Finished {
    ManifestImage image;
    bool current = false;
};
using FinishedImages = std::map<std::string, Finished>;  ///< by file

/// Every image that some manifest in the folder calls finished, whose bytes are as it says and
/// which shows what the study asks. Where several do, a current one wins.
[[nodiscard]] FinishedImages finished_images(const Study& study, const StimulusRenderer& renderer,
                                             const std::filesystem::path& folder);

[[nodiscard]] bool is_current(const FinishedImages& finished, const std::string& file);

/// The finished images in the study's order.
[[nodiscard]] Manifest manifest_of(const Study& study, const FinishedImages& finished,
                                   const std::string& gpu_renderer);

/// An image that is finished already, wherever: another one of the same inputs is not rendered.
struct Twin {
    std::filesystem::path file;
    ManifestImage image;
};
using Twins = std::map<std::string, Twin>;  ///< by the hash of their inputs

void add_twins(const FinishedImages& finished, const std::filesystem::path& folder, Twins& twins);

/// As people are told of it: `I-a.png (Crytek24)`.
[[nodiscard]] std::string title_of(const Stimulus& stimulus);

/// Compresses, writes, lists and compares images, one while the next is drawn. Needs no context but
/// while it is made.
class Finishing {
  public:
    /// `finished` and `twins` are added to, and not to be looked at before the end.
    Finishing(const Study& study, std::filesystem::path folder, std::filesystem::path list,
              FinishedImages& finished, Twins& twins, base::Progress& progress);

    void begin(const Stimulus& stimulus, ManifestImage entry, RgbImage image);
    void copy(const Stimulus& stimulus, const std::string& inputs_sha256);
    void keep(const Stimulus& stimulus);
    /// The pairs whose two images were made.
    [[nodiscard]] std::vector<ManifestPair> end();

  private:
    void await_last();
    void finish(const Stimulus& stimulus, const ManifestImage& entry, RgbImage image,
                const std::string& bytes, const std::string& told);

    const Study& study_;
    std::filesystem::path folder_;
    std::filesystem::path list_;
    std::string gpu_;
    FinishedImages& finished_;
    Twins& twins_;
    base::Progress& progress_;
    PairsInTheMaking made_;
    std::future<void> last_;  ///< goes first, so that it ends before what it uses
};

}  // namespace obscura::stimuli
