// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/frame/phase.h"
#include "renderer/light/lighting.h"
#include "renderer/light/shadow.h"
#include "renderer/recipe/recipe.h"
#include "renderer/scene/scene.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// A buffer with the size that an image gives it.
struct PlannedTarget : Buffer {
    int width = 0;  ///< in texels
    int height = 0;
    int row = 0;            ///< what lies in a row: as the width where a texel holds one column
    std::size_t bytes = 0;  ///< of all levels and layers

    bool operator==(const PlannedTarget&) const = default;
};

/// One of the house's passes, or a step of a recipe.
struct PlannedPass {
    Phase phase = Phase::kGeometry;
    std::string name;
    std::vector<Read> reads;          ///< of buffers, by the names they have in this plan
    std::vector<std::string> writes;  ///< the same
    /// Nothing: a pass of the house. Its reads and writes are the recipe's words.
    std::optional<Step> step = {};
    std::vector<NumberTable> tables = {};  ///< that the step reads
    int frame = 0;                         ///< of the recipe's
};

/// Something a frame could have had and why this one has not.
struct LeftOut {
    std::string what;
    std::string why;
};

/// What a scene and its light ask for; all that the plan knows of them.
struct SceneNeeds {
    bool environment = false;
    bool irradiance_grid = false;  ///< its irradiance depends on where one stands
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
    Variant variant;
    std::map<std::string, double> parameters;  ///< the technique's: `p_<name>` in its steps
    bool technique_reads_depth = false;
    bool makes_colour = false;  ///< the technique does, in place of accessibility
    int ao_step = 1;  ///< the technique computes every so many columns and rows of the image
    double separation_m = 0.0;  ///< of the second layer from the first
    int second_step = 1;        ///< what the technique sees over what the second layer has
    std::vector<PlannedTarget> targets;
    std::vector<PlannedPass> passes;
    std::vector<LeftOut> left_out;

    [[nodiscard]] const PlannedTarget* find(std::string_view buffer) const;
    [[nodiscard]] bool has(Phase phase) const;
    [[nodiscard]] std::size_t bytes() const;
    /// Whether there is an accessibility that the composite uses.
    [[nodiscard]] bool makes_accessibility() const;
    /// The buffer that holds it: `accessibility`, `denoised` or `upsampled`.
    [[nodiscard]] std::string final_accessibility() const;
    /// What passes/accessibility_texel.glsl has to know of that buffer.
    [[nodiscard]] std::string accessibility_define() const;
    /// Whether the technique sees nearly opaque blended surfaces.
    [[nodiscard]] bool blended_occlude() const;
    /// Whether normals are stored in a way that the image's own G-buffer has not.
    [[nodiscard]] bool own_normals() const {
        return variant.normal_format == "rg8" || variant.normal_format == "oct16";
    }
    /// Whether what the technique sees is drawn once more, and not copied from the G-buffer.
    [[nodiscard]] bool draws_occluders() const {
        return options.supersampling > 1 || own_normals();
    }
    /// Whether surfaces are lit while they are drawn a second time, and not from a G-buffer (Sunet
    /// 2018, 4.2).
    [[nodiscard]] bool lit_forward() const { return variant.pipeline == "nd-buffer"; }
    /// The buffer of the image's pixels for depth, normal, position or visibility: what the
    /// technique sees where it has one value a pixel.
    [[nodiscard]] std::string of_pixels(std::string_view buffer) const;
    /// The buffer that the technique reads for depth, normal, position or visibility.
    [[nodiscard]] std::string seen_by_technique(std::string_view buffer) const;
    /// Whether the image is kept in linear light before it becomes sRGB code values.
    [[nodiscard]] bool hdr() const { return needs.hdr() || makes_colour; }
    /// The buffer that holds the image in linear light once the technique is done: `hdr` or
    /// `colour`.
    [[nodiscard]] std::string linear_image() const;
    /// The buffer that holds the image: `display` or `resolved`.
    [[nodiscard]] std::string image() const;
};

/// The plan of an image of width x height pixels: the house's passes and the steps of the
/// technique's and the filter's recipes in one list. Throws bad input when the variant has
/// problems, an option is out of its range or the passes' size is outside 1 .. 16384; failure for a
/// recipe that reads or writes what there is not.
[[nodiscard]] FramePlan plan_frame(const SceneNeeds& needs, const Variant& variant, int width,
                                   int height, const FrameOptions& options = {});

/// The same for a technique that need not be in the list; nothing of it is checked but its recipe.
[[nodiscard]] FramePlan plan_frame(const SceneNeeds& needs, const Technique& technique,
                                   const Variant& variant, int width, int height,
                                   const FrameOptions& options = {});

}  // namespace obscura::renderer
