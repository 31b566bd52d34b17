// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
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

/// The buffers of one rendered image, until the next one is wanted.
class Frame {
  public:
    explicit Frame(FramePlan plan);

    [[nodiscard]] const FramePlan& plan() const { return plan_; }
    [[nodiscard]] GLuint texture(Target target) const { return textures_.at(target).name(); }

    /// The image: width * height * 3 sRGB code values, upper row first.
    [[nodiscard]] std::vector<std::uint8_t> read_display() const;
    /// A one-channel float target (depth, accessibility, denoised), upper row first.
    [[nodiscard]] std::vector<float> read_floats(Target target) const;
    /// The first `channels` (1 to 4) components of any colour target as the shaders stored them,
    /// pixel by pixel, upper row first: code values in [0, 1] for an 8-bit target.
    [[nodiscard]] std::vector<float> read_components(Target target, int channels) const;
    /// The stored bytes of any target of the image's size, as OpenGL holds them.
    [[nodiscard]] std::vector<std::uint8_t> read_bytes(Target target) const;

    std::vector<PassTime> times;

  private:
    FramePlan plan_;
    std::map<Target, gl::Texture> textures_;
};

}  // namespace obscura::renderer
