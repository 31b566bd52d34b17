// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/target.h"
#include "renderer/light/lighting.h"
#include "renderer/light/shadow.h"
#include "renderer/scene/scene.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {

struct PlannedTarget {
    Target target = Target::kDisplay;
    std::string format;
    int width = 0;
    int height = 0;
    int layers = 1;
    std::size_t bytes = 0;

    bool operator==(const PlannedTarget&) const = default;
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
    bool roughness = false;       ///< some material has a roughness texture, and there are lights
    bool cut_out = false;         ///< some material has holes
    bool blended = false;         ///< some material is seen through
    bool emission = false;        ///< some material sends out light or has baked accessibility
    int shadow_size = 0;          ///< texels along one side of a shadow map
    int point_shadow_size = 0;    ///< the same of each side of a point light's cube

    [[nodiscard]] bool direct_light() const { return lights > 0 || point_lights > 0; }
    /// Whether the image is kept in linear light before it becomes sRGB code values.
    [[nodiscard]] bool hdr() const { return tone_mapping || blended; }
    bool operator==(const SceneNeeds&) const = default;
};
[[nodiscard]] SceneNeeds needs_of(const Scene& scene, const Lighting& lighting);
[[nodiscard]] SceneNeeds needs_of(const std::vector<Material>& materials, const Bounds& bounds,
                                  const Lighting& lighting);

/// What is asked of an image beside its technique.
struct FrameOptions {
    /// Samples along each side of a pixel, 1 to 4: surfaces and light are computed for every
    /// sample, and the samples of a pixel are averaged in linear light after tone mapping.
    /// Accessibility is computed once a pixel, whatever this is, so that a variant's number of
    /// samples is what its name says; each sample takes that of the pixel around it whose surface
    /// is nearest in depth.
    int supersampling = 1;
    /// Blended surfaces at least this opaque, (0, 1], are seen by the technique (Filion and
    /// McNaughton 2008); nothing: none are.
    std::optional<float> occluding_opacity = {};
    /// Normal and depth are kept though nothing reads them, to be written beside the image.
    bool all_buffers = false;

    bool operator==(const FrameOptions&) const = default;
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
    bool technique_reads_depth = false;
    std::vector<PlannedTarget> targets;
    std::vector<PlannedPass> passes;
    std::vector<LeftOut> left_out;

    [[nodiscard]] const PlannedTarget* find(Target target) const;
    [[nodiscard]] bool has(Pass pass) const;
    [[nodiscard]] std::size_t bytes() const;
    /// The buffer that holds the accessibility the composite uses: kAccessibility or kDenoised.
    [[nodiscard]] Target final_accessibility() const;
    /// Whether the technique sees nearly opaque blended surfaces.
    [[nodiscard]] bool blended_occlude() const;
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
