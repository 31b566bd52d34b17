// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// The images that a frame may need, after Jakobsen 2010, Tables 1 and 2.
enum class Target {
    kAlbedo,         ///< srgb8_alpha8: albedo, specular intensity
    kNormal,         ///< rgba8: view-space normal, specular power / 255
    kDepth,          ///< r32f or r16f: positive view distance in metres; where empty,
                     ///< kBackgroundDepth_m, in 16 bits infinity
    kVisibility,     ///< depth24: which triangle is in front, and which pixels are empty
    kShadow,         ///< depth32f, one layer a light
    kAccessibility,  ///< r32f: what the technique wrote, 1 where empty
    kDenoiseStep,    ///< r32f: between two passes of a filter
    kDenoised,       ///< r32f: what the composite reads after a filter
    kAmbient,        ///< rgba16f: irradiance / pi from the environment
    kDirect,         ///< rgba16f: irradiance / pi from the lights, specular light
    kHdr,            ///< rgba16f: the image before tone mapping
    kDisplay,        ///< rgba8: the image, sRGB code values
};

/// What the frame does, in this order.
enum class Pass {
    kGeometry,
    kShadow,
    kAccessibility,
    kDenoise,
    kLight,
    kComposite,
    kSky,
    kToneMap,
};

[[nodiscard]] std::string to_string(Target target);
[[nodiscard]] std::string to_string(Pass pass);

struct PlannedTarget {
    Target target = Target::kDisplay;
    std::string format;
    int width = 0;
    int height = 0;
    int layers = 1;
    std::size_t bytes = 0;
};

struct PlannedPass {
    Pass pass = Pass::kGeometry;
    std::vector<Target> reads;
    std::vector<Target> writes;
};

/// Something a frame could have had and why this one has not.
struct LeftOut {
    std::string what;
    std::string why;
};

/// What a scene and its light ask for; all that the plan knows of them.
struct SceneNeeds {
    bool environment = false;
    int lights = 0;
    bool tone_mapping = false;
    bool normal_mapping = false;  ///< asked for, and some material has a normal map
    bool textures = false;        ///< some material has an albedo texture
    bool specular = false;        ///< some material has a specular intensity, and there are lights
    int shadow_size = 0;          ///< texels along one side of a shadow map
};
[[nodiscard]] SceneNeeds needs_of(const Scene& scene, const Lighting& lighting);

/// The passes and buffers of one image: only what scene and technique declare they need.
struct FramePlan {
    int width = 0;
    int height = 0;
    SceneNeeds needs;
    std::vector<PlannedTarget> targets;
    std::vector<PlannedPass> passes;
    std::vector<LeftOut> left_out;

    [[nodiscard]] const PlannedTarget* find(Target target) const;
    [[nodiscard]] bool has(Pass pass) const;
    [[nodiscard]] std::size_t bytes() const;
    /// The buffer that holds the accessibility the composite uses: kAccessibility or kDenoised.
    [[nodiscard]] Target final_accessibility() const;
};

/// Throws bad input when the choice has problems or a size is outside 1 .. 16384.
[[nodiscard]] FramePlan plan_frame(const SceneNeeds& needs, const TechniqueChoice& choice,
                                   int width, int height);

}  // namespace obscura::renderer
