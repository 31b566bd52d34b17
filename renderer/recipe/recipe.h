// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/recipe/buffer.h"

namespace obscura::renderer {

/// A buffer or table that a step reads, bound to the sampler `t_<as>`, blanks as underscores.
struct Read {
    Read(const Buffer& buffer) : Read(buffer.name) {}                // NOLINT
    Read(std::string buffer) : name(std::move(buffer)), as(name) {}  // NOLINT
    Read(const char* buffer) : Read(std::string(buffer)) {}          // NOLINT
    Read(std::string buffer, std::string sampler)
        : name(std::move(buffer)), as(std::move(sampler)) {}

    std::string name;
    std::string as;
};

/// Numbers made once for a recipe (a kernel, a tile of rotations): an unfiltered texture of
/// width x height vectors, row by row.
struct NumberTable {
    std::string name;
    int width = 1;
    int height = 1;
    std::vector<glm::vec3> texels;
};

struct Camera;
class ReferenceScene;

/// What a step that is computed on the processor is given.
struct ProcessorWork {
    int width = 0;  ///< of what it reads and writes: the image's
    int height = 0;
    /// What the step reads, in its order, lower row first: one number a texel, of normals the three
    /// components of unit vectors.
    std::vector<std::vector<float>> reads;
    const Camera& camera;
    const ReferenceScene& rays;  ///< the scene's triangles
    const std::map<std::string, double>& parameters;
    int samples = 0;
};
/// Gives one value a texel, lower row first; 1 where nothing is seen.
using ProcessorStep = std::vector<float> (*)(const ProcessorWork& work);

/// Which texels a step draws.
enum class Cover {
    kSurfaces,  ///< those that a triangle covers; the others are 1. For one level and layer of the
                ///< image's size
    kAll,
};

/// One full-screen shader, drawn once for each level and layer of what it writes; or one function
/// on the processor. Beside what it reads a shader may use: `u_size` (texels of the level),
/// `u_ray_scale`, `u_ray_offset`, `u_ray_to_px`, `u_axis_px` (passes/view.glsl), `u_far_m`,
/// `u_level`, `u_layer`, `u_frame`, `u_samples` (of the technique) and `p_<parameter>`.
struct Step {
    std::string name;    ///< in plans and timings, where neighbours of one name count as one
    std::string shader;  ///< path below renderer/
    /// Buffers of the recipe, `depth`, `normal`, `position` (bound where the variant stores it; the
    /// shader takes points from passes/view.glsl), `accessibility` (of a filter), `colour` (of a
    /// technique that makes colour), `history`, or tables of the recipe. A buffer that the step
    /// itself writes is seen at the level above the one that is drawn.
    std::vector<Read> reads;
    std::string writes;  ///< a buffer of the recipe, `accessibility`, `denoised` or `colour`
    std::vector<std::string> defines;  ///< each `#define TEXT`
    int fetches = 0;                   ///< the most texture reads of one texel that it draws
    Cover cover = Cover::kSurfaces;
    int first_level = 0;  ///< of the levels that it draws
    int levels = 0;       ///< how many of them; 0: to the last
    /// Pixels of a row that share a texel of what it writes, where that is the house's: then it
    /// covers all.
    int columns = 1;
    int frame = -1;  ///< of the recipe's frames that it is run in; below 0: in each
    /// In place of a shader: computed on the processor, from buffers that are read back, and
    /// uploaded. It writes a buffer of the image's size in one component. With a shader beside it,
    /// that is run where steps are computed on a GPU (frame/renderer.h).
    ProcessorStep processor = nullptr;
    /// It writes accessibility, or as a filter's reads it, also with the depth beside it: where
    /// DEPTH_BESIDE is defined (recipe/depth_beside.h).
    bool depth_beside = false;
    bool traces = false;  ///< its shader includes technique/rays.glsl

    /// Whether it is run in that frame.
    [[nodiscard]] bool is_in(int of_frame) const { return frame < 0 || frame == of_frame; }
    /// Whether it reads a buffer or table of that name.
    [[nodiscard]] bool reads_buffer(std::string_view name) const;
    /// The level behind the last that is drawn of a buffer with so many.
    [[nodiscard]] int end_level(int of_levels) const {
        return levels > 0 && first_level + levels < of_levels ? first_level + levels : of_levels;
    }
};

/// What a technique or a denoise filter computes in a frame.
struct Recipe {
    std::vector<Buffer> buffers;  ///< its own; sizes are relative to what it makes
    std::vector<NumberTable> tables;
    std::vector<Step> steps;
    int frames = 1;  ///< how often the steps are run, with `u_frame` counting from 0
    /// Where a step reads `second depth`: how far behind the first layer the second lies at least,
    /// and how often the sides of its buffer are halved.
    double separation_m = 0.0;
    int second_halvings = 0;

    /// Whether some step is computed on the processor.
    [[nodiscard]] bool on_processor() const;
    /// Whether some step reads it.
    [[nodiscard]] bool reads(std::string_view name) const;
    [[nodiscard]] const Buffer* find_buffer(std::string_view name) const;
    [[nodiscard]] const NumberTable* find_table(std::string_view name) const;
};

/// The most texture reads that all steps make, over the pixels of the image; rounded up.
[[nodiscard]] int fetches_per_pixel(const Recipe& recipe);

}  // namespace obscura::renderer
