// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "renderer/frame/plan.h"
#include "renderer/gl/handles.h"

namespace obscura::renderer {

/// How long one pass took.
struct PassTime {
    Pass pass = Pass::kGeometry;
    double milliseconds = 0.0;        ///< by glFinish and a monotonic clock: right on every driver
    double query_milliseconds = 0.0;  ///< by GL timestamps: wrong on a software renderer
};

/// Buffers of a rendered image that do not depend on what its technique found: surfaces, shadow
/// maps and light. Another image of the same scene, light and camera may take them over.
struct ViewBuffers {
    FramePlan plan;
    std::map<Target, std::shared_ptr<gl::Texture>> textures;
    std::vector<PassTime> times;  ///< of the passes that made them
};

/// The buffers of one rendered image, until the next one is wanted.
class Frame {
  public:
    /// Takes over, of `known`, the results of every pass whose outcome would be the same to the
    /// bit: the plans agree on needs, options and all the targets that it reads and writes.
    explicit Frame(FramePlan plan, const ViewBuffers& known = {});

    [[nodiscard]] const FramePlan& plan() const { return plan_; }
    [[nodiscard]] GLuint texture(Target target) const { return textures_.at(target)->name(); }
    /// The passes whose results were taken over, with the time that they took then.
    [[nodiscard]] const std::vector<PassTime>& taken_over() const { return taken_over_; }
    /// What another image of the view may take over.
    [[nodiscard]] ViewBuffers view_buffers() const;

    /// The image: width * height * 3 sRGB code values, upper row first.
    [[nodiscard]] std::vector<std::uint8_t> read_display() const;
    /// A one-channel float target (depth, accessibility, denoised), upper row first.
    [[nodiscard]] std::vector<float> read_floats(Target target) const;
    /// What the composite uses: the accessibility after its filter, 1 everywhere where there is
    /// none; one value a pixel, upper row first.
    [[nodiscard]] std::vector<float> read_accessibility() const;
    /// The first `channels` (1 to 4) components of any colour target as the shaders stored them,
    /// pixel by pixel, upper row first: code values in [0, 1] for an 8-bit target.
    [[nodiscard]] std::vector<float> read_components(Target target, int channels) const;
    /// The stored bytes of any target of the image's size, as OpenGL holds them.
    [[nodiscard]] std::vector<std::uint8_t> read_bytes(Target target) const;

    std::vector<PassTime> times;  ///< of all passes, in their order

  private:
    FramePlan plan_;
    std::map<Target, std::shared_ptr<gl::Texture>> textures_;
    std::vector<PassTime> taken_over_;
};

}  // namespace obscura::renderer
