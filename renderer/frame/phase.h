// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::renderer {

/// What a frame does, in this order. The house does each with one pass of its own, but the
/// technique and denoise: those are steps of recipes, or the ray tracer. The steps of a technique
/// that makes colour come after the sky.
enum class Phase {
    kGeometry,
    kShadow,
    kOccluders,
    kSeen,
    kSecondLayer,
    kTechnique,
    kDenoise,
    kUpsample,
    kLight,
    kComposite,
    kForward,
    kSky,
    kBlend,
    kToneMap,
    kResolve,
};

/// The name of the house's pass in that phase, `geometry`; of the ray tracer's, `accessibility`.
[[nodiscard]] std::string to_string(Phase phase);

/// Whether the time of that phase is what a variant costs.
[[nodiscard]] inline bool is_of_the_variant(Phase phase) {
    return phase == Phase::kSeen || phase == Phase::kTechnique || phase == Phase::kDenoise ||
           phase == Phase::kUpsample;
}

}  // namespace obscura::renderer
