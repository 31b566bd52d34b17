// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace obscura::app::explorer {

/// How the image area is shared out.
enum class Arrangement {
    kOne,      ///< one pane
    kSplit,    ///< A left of a line that can be dragged, B right of it, in one place
    kFour,     ///< two by two
    kFlicker,  ///< A and B in turn
};
inline constexpr std::array kArrangements{Arrangement::kOne, Arrangement::kSplit,
                                          Arrangement::kFour, Arrangement::kFlicker};
[[nodiscard]] const char* to_string(Arrangement arrangement);

/// What a pane may show beside the technique's own buffers, whose layers are kOwn and their name.
namespace layer {
inline constexpr const char* kImage = "image";
inline constexpr const char* kAccessibility = "accessibility";
inline constexpr const char* kError = "error";
inline constexpr const char* kTruth = "truth";
inline constexpr const char* kTruthError = "truth's error";
inline constexpr const char* kAlbedo = "albedo";
inline constexpr const char* kNormal = "normal";
inline constexpr const char* kDepth = "depth";
inline constexpr const char* kLight = "light";
inline constexpr const char* kEmission = "emission";
inline constexpr const char* kOwn = "own: ";
/// In the order of menus and keys.
inline constexpr std::array kAll{kImage,  kAccessibility, kError, kTruth, kTruthError,
                                 kAlbedo, kNormal,        kDepth, kLight, kEmission};
/// What it shows, a sentence.
[[nodiscard]] std::string meaning_of(const std::string& layer);
}  // namespace layer

/// What one pane shows.
struct Pane {
    char side = 'a';
    std::string layer = layer::kImage;
    [[nodiscard]] bool operator==(const Pane&) const = default;
};

/// How the image area is looked at; not part of what undo covers.
struct Layout {
    Arrangement arrangement = Arrangement::kSplit;
    std::array<Pane, 4> panes{Pane{'a', layer::kImage}, Pane{'b', layer::kImage},
                              Pane{'b', layer::kAccessibility}, Pane{'b', layer::kError}};
    float split = 0.5F;  ///< where the line is, [0, 1] of the pane's width
    double flicker_hz = 1.0;
    /// Screen pixels of one of the image's; 0: as large as the pane holds.
    float zoom = 0.0F;
    glm::vec2 middle{0.5F};    ///< what of the image is in the middle of a pane, [0, 1]
    float depth_low_m = 0.0F;  ///< of the depth's colour scale; high 0: of what is seen
    float depth_high_m = 0.0F;
    float error_range = 0.25F;  ///< the error's colours end there, > 0
    [[nodiscard]] bool operator==(const Layout&) const = default;

    /// The panes that are seen at that time, from left to right and top to bottom.
    [[nodiscard]] std::vector<Pane> visible(double time_s) const;
    /// The same over all times.
    [[nodiscard]] std::vector<Pane> ever_visible() const;
    /// What is nonsense is made what is next to it.
    [[nodiscard]] Layout sane() const;
};

inline constexpr float kMostZoom = 64.0F;
inline constexpr double kMostFlicker_hz = 10.0;  ///< faster could hurt people who see it

/// The next zoom, larger or smaller: powers of two up to kMostZoom, and 0 where it would be no
/// larger than `whole`, that of an image as large as its pane holds.
[[nodiscard]] float next_zoom(float zoom, bool larger, float whole);

}  // namespace obscura::app::explorer
