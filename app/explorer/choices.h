// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "renderer/technique/technique.h"
#include "stimuli/study.h"

namespace obscura::app::explorer {

/// All that decides an image but where the camera is.
struct Choices {
    /// Source, level and settings; its camera is where one last began to fly.
    stimuli::StudyScene scene;
    std::filesystem::path folder;  ///< what paths of the scene are relative to
    int width = 1280;              ///< of the image in pixels
    int height = 720;
    int supersampling = 1;
    std::optional<float> occluding_opacity;
    renderer::Variant a;
    renderer::Variant b;
    std::optional<double> truth_radius_m;  ///< R of the truth; nothing: standard_truth_radius_m

    [[nodiscard]] const renderer::Variant& side(char which) const { return which == 'a' ? a : b; }
    [[nodiscard]] renderer::Variant& side(char which) { return which == 'a' ? a : b; }
    [[nodiscard]] bool operator==(const Choices& other) const;
};

inline constexpr int kMostImageSide = 16384;

/// Whether the two need the same triangles, so that nothing has to be opened.
[[nodiscard]] bool same_source(const Choices& a, const Choices& b);

/// R that B reaches to, else A, else the first technique's that has one.
[[nodiscard]] double standard_truth_radius_m(const Choices& choices);
[[nodiscard]] double truth_radius_m(const Choices& choices);

/// The technique as a study means it where it says no more, but with the radius that `before` has
/// where both have one: it is of the scene.
[[nodiscard]] renderer::Variant switched_to(const renderer::Technique& technique,
                                            const renderer::Variant& before);

/// As near to what is wanted as the technique allows.
[[nodiscard]] int allowed_samples(const renderer::Technique& technique, int wanted);
/// The same of a parameter; nothing for what is no number.
[[nodiscard]] std::optional<double> allowed_value(const renderer::Parameter& parameter,
                                                  double wanted);

}  // namespace obscura::app::explorer
