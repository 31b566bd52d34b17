// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// The images that a frame may need, after Jakobsen 2010, Tables 1 and 2.
enum class Target {
    kAlbedo,          ///< srgb8_alpha8: albedo, specular intensity
    kNormal,          ///< rgba8: view-space normal, specular power / 255
    kDepth,           ///< r32f or r16f: positive view distance in metres; where empty,
                      ///< kBackgroundDepth_m, in 16 bits infinity
    kVisibility,      ///< depth24: which triangle is in front, and which pixels are empty
    kShadow,          ///< depth32f, one layer a directional light
    kPointShadow,     ///< depth32f, six layers a point light: +X -X +Y -Y +Z -Z
    kEmission,        ///< rgba16f: light sent out, baked accessibility
    kOccluderDepth,   ///< r32f: depth with nearly opaque blended surfaces in it, for the technique
    kOccluderNormal,  ///< rgba8: the same of the normal
    kOccluderVisibility,  ///< depth24: the same of the visibility
    kAccessibility,       ///< r32f: what the technique wrote, 1 where empty
    kDenoiseStep,         ///< r32f: between two passes of a filter
    kDenoised,            ///< r32f: what the composite reads after a filter
    kAmbient,             ///< rgba16f: irradiance / pi from the environment
    kDirect,              ///< rgba16f: irradiance / pi from the lights, specular light
    kHdr,                 ///< rgba16f: the image in linear light, before tone mapping
    kDisplay,             ///< rgba8: the image, sRGB code values
    kResolved,            ///< rgba8: the image at its final size, where pixels take several samples
};

/// What the frame does, in this order.
enum class Pass {
    kGeometry,
    kShadow,
    kOccluders,
    kAccessibility,
    kDenoise,
    kLight,
    kComposite,
    kSky,
    kBlend,
    kToneMap,
    kResolve,
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
    int point_lights = 0;
    bool tone_mapping = false;
    bool normal_mapping = false;  ///< asked for, and some material has a normal map
    bool textures = false;        ///< some material has an albedo texture
    bool specular = false;        ///< some material has a specular intensity, and there are lights
    bool cut_out = false;         ///< some material has holes
    bool blended = false;         ///< some material is seen through
    bool emission = false;        ///< some material sends out light or has baked accessibility
    int shadow_size = 0;          ///< texels along one side of a shadow map
    int point_shadow_size = 0;    ///< the same of each side of a point light's cube

    [[nodiscard]] bool direct_light() const { return lights > 0 || point_lights > 0; }
    /// Whether the image is kept in linear light before it becomes sRGB code values.
    [[nodiscard]] bool hdr() const { return tone_mapping || blended; }
};
[[nodiscard]] SceneNeeds needs_of(const Scene& scene, const Lighting& lighting);

/// What is asked of an image beside its technique.
struct FrameOptions {
    /// Samples along each side of a pixel, 1 to 4. All passes run on every sample; the samples of a
    /// pixel are averaged in linear light after tone mapping.
    int supersampling = 1;
    /// Blended surfaces at least this opaque, (0, 1], are seen by the technique (Filion and
    /// McNaughton 2008); nothing: none are.
    std::optional<float> occluding_opacity = {};
    /// Normal and depth are kept though nothing reads them, to be written beside the image.
    bool all_buffers = false;
};
inline constexpr int kMostSupersampling = 4;

/// The passes and buffers of one image: only what scene and technique declare they need.
struct FramePlan {
    int width = 0;  ///< of the passes: the image's, times the supersampling
    int height = 0;
    int image_width = 0;  ///< of the image
    int image_height = 0;
    FrameOptions options;
    SceneNeeds needs;
    std::vector<PlannedTarget> targets;
    std::vector<PlannedPass> passes;
    std::vector<LeftOut> left_out;

    [[nodiscard]] const PlannedTarget* find(Target target) const;
    [[nodiscard]] bool has(Pass pass) const;
    [[nodiscard]] std::size_t bytes() const;
    /// The buffer that holds the accessibility the composite uses: kAccessibility or kDenoised.
    [[nodiscard]] Target final_accessibility() const;
    /// The buffer that the technique reads for kDepth, kNormal or kVisibility.
    [[nodiscard]] Target seen_by_technique(Target target) const;
    /// The buffer that holds the image: kDisplay or kResolved.
    [[nodiscard]] Target image() const;
};

/// The plan of an image of width x height pixels. Throws bad input when the choice has problems, an
/// option is out of its range or the passes' size is outside 1 .. 16384.
[[nodiscard]] FramePlan plan_frame(const SceneNeeds& needs, const TechniqueChoice& choice,
                                   int width, int height, const FrameOptions& options = {});

}  // namespace obscura::renderer
