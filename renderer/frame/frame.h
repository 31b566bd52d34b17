// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/frame/plan.h"
#include "renderer/frame/texture_pool.h"
#include "renderer/gl/handles.h"

namespace obscura::renderer {

/// How long one pass or step took.
struct PassTime {
    Phase phase = Phase::kGeometry;
    std::string name;
    double milliseconds = 0.0;        ///< by glFinish and a monotonic clock: right on every driver
    double query_milliseconds = 0.0;  ///< by GL timestamps: wrong on a software renderer
};

/// The same with neighbours of one name added up: the passes as people are told of them.
[[nodiscard]] std::vector<PassTime> by_name(const std::vector<PassTime>& times);

/// Buffers of a rendered image that do not depend on what its technique found: surfaces, shadow
/// maps and light. Another image of the same scene, light and camera may take them over.
struct ViewBuffers {
    FramePlan plan;
    std::map<std::string, std::shared_ptr<gl::Texture>, std::less<>> textures;
    std::vector<PassTime> times;  ///< of the passes that made them
};

/// The buffers of one rendered image, until the next one is wanted.
class Frame {
  public:
    /// Takes over, of `known`, the results of every pass whose outcome would be the same to the
    /// bit: the plans agree on needs, options and all the targets that it reads and writes.
    Frame(FramePlan plan, const ViewBuffers& known, TexturePool& pool);

    [[nodiscard]] const FramePlan& plan() const { return plan_; }
    /// Throws failure for a buffer that the plan has not.
    [[nodiscard]] GLuint texture(std::string_view buffer) const;
    /// The passes whose results were taken over, with the time that they took then.
    [[nodiscard]] const std::vector<PassTime>& taken_over() const { return taken_over_; }
    /// Of all passes.
    [[nodiscard]] double milliseconds() const;
    /// What another image of the view may take over.
    [[nodiscard]] ViewBuffers view_buffers() const;

    /// The image: width * height * 3 sRGB code values, upper row first.
    [[nodiscard]] std::vector<std::uint8_t> read_display() const;
    /// A one-channel float buffer (depth, accessibility, denoised), upper row first.
    [[nodiscard]] std::vector<float> read_floats(std::string_view buffer) const;
    /// What the composite uses: the accessibility after its filter, 1 everywhere where there is
    /// none; one value a pixel, upper row first.
    [[nodiscard]] std::vector<float> read_accessibility() const;
    /// The first `channels` (1 to 4) components of a mip level of any colour buffer as the shaders
    /// stored them, pixel by pixel, upper row first, layer after layer: code values in [0, 1] for
    /// an 8-bit buffer.
    [[nodiscard]] std::vector<float> read_components(std::string_view buffer, int channels,
                                                     int level = 0) const;
    /// 1 where a visibility buffer has no triangle, else 0; upper row first. A depth does not
    /// always say so: half floats hold no depth beyond 65504 m.
    [[nodiscard]] std::vector<std::uint8_t> read_empty(std::string_view visibility) const;
    /// The stored bytes of the first level of any buffer, as OpenGL holds them.
    [[nodiscard]] std::vector<std::uint8_t> read_bytes(std::string_view buffer) const;

    std::vector<PassTime> times;  ///< of all passes, in their order

  private:
    [[nodiscard]] const PlannedTarget& planned(std::string_view buffer) const;
    [[nodiscard]] std::vector<float> read_columns(const PlannedTarget& target, int channels) const;

    FramePlan plan_;
    std::map<std::string, std::shared_ptr<gl::Texture>, std::less<>> textures_;
    std::vector<PassTime> taken_over_;
};

}  // namespace obscura::renderer
