// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/reference/exr.h"
#include "stimuli/manifest.h"
#include "stimuli/png.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// How far the images of each pair are apart, in the study's order, of those pairs whose images the
/// folder holds and the manifest lists as what the study asks for. What the manifest knows of the
/// same images is taken over, the rest compared.
[[nodiscard]] std::vector<ManifestPair> compared_pairs(const Study& study, const Manifest& manifest,
                                                       const std::filesystem::path& folder);

/// The same of the images in a folder with its manifest.json; none where there is none to be read.
[[nodiscard]] std::vector<ManifestPair> compared_pairs(const Study& study,
                                                       const std::filesystem::path& folder);

/// Compares pairs whose images are made one after the other, a before b, so that none has to be
/// read again.
class PairsInTheMaking {
  public:
    void add(const ManifestImage& entry, RgbImage image);
    [[nodiscard]] const std::vector<ManifestPair>& pairs() const { return pairs_; }

  private:
    std::string condition_;  ///< of the last image
    std::string sha256_;
    RgbImage image_;
    std::vector<ManifestPair> pairs_;
};

/// A sentence for each pair whose images nobody could tell apart though the study does not mark it
/// as `identical`, with the likely reason where it is known.
[[nodiscard]] std::vector<std::string> alike_pairs(const Study& study,
                                                   const std::vector<ManifestPair>& pairs);

/// A sentence for each pair that is marked as `identical` and differs visibly.
[[nodiscard]] std::vector<std::string> falsely_identical_pairs(
    const Study& study, const std::vector<ManifestPair>& pairs);

/// A sentence for each pair that can be seen and hardly differs (kHardlyVisible), and for each
/// attention check that is not obvious (kObvious).
[[nodiscard]] std::vector<std::string> faint_pairs(const Study& study,
                                                   const std::vector<ManifestPair>& pairs);

/// All of them.
[[nodiscard]] std::vector<std::string> warnings_of(const Study& study,
                                                   const std::vector<ManifestPair>& pairs);

/// What a pair's images are, a sentence each: the share of pixels that differ noticeably, mean
/// luminance and contrast of both, the error of both against the truth and which is the more
/// accurate, of the pairs that the manifest lists both images of and
/// that are not meant to be identical.
[[nodiscard]] std::vector<std::string> facts_of(const Study& study, const Manifest& manifest,
                                                const std::vector<ManifestPair>& pairs);

/// A sentence for each condition of a hypothesis about accuracy whose image b is, as measured, not
/// clearly the more accurate one (kLeastOrder).
[[nodiscard]] std::vector<std::string> disordered_claims(const Study& study,
                                                         const Manifest& manifest);

/// Each side's channels `Z`, `ao.Y`, `albedo` and `light`, as StimulusRenderer::render_buffers
/// gives them.
struct PairBuffers {
    renderer::FloatImage a;
    renderer::FloatImage b;
};

/// Why the images of that condition are alike, as a clause that tells what was met: nothing in
/// view, surfaces that cannot be seen, nothing occluded and by which radius, the same accessibility
/// on both sides, or light that hides it.
[[nodiscard]] std::string reason_of_likeness(const Condition& condition,
                                             const renderer::Scene& scene,
                                             const renderer::Camera& camera,
                                             const PairBuffers& buffers);

}  // namespace obscura::stimuli
