// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/kiosk/session_plan.h"
#include "app/kiosk/window.h"
#include "renderer/gl/handles.h"

namespace obscura::app::kiosk {

/// An image's bytes as stored: RGBA with alpha 255, rows from the bottom to the top.
struct StimulusPixels {
    Extent extent;
    std::vector<std::uint8_t> rgba;
};

/// Reads an 8-bit PNG of the study's folder as it is, without colour conversion. Throws bad input
/// naming the file when it cannot be read, its bytes do not have the hash that `image` says, it is
/// no 8-bit image, or its size is not `extent`.
[[nodiscard]] StimulusPixels load_stimulus(const std::filesystem::path& folder,
                                           const StimulusImage& image, Extent extent);

/// An image on the GPU, ready to be shown at once. Needs a current context.
class StimulusTexture {
  public:
    /// Throws failure with the size and OpenGL's reason when the GPU cannot hold it.
    explicit StimulusTexture(const StimulusPixels& pixels);

    /// Copies it into the middle of the window's frame, pixel for pixel; all around is grey.
    void draw(Extent frame, int grey_level) const;

  private:
    Extent extent_;
    renderer::gl::Texture texture_;
    renderer::gl::Framebuffer framebuffer_;
};

/// Fills the frame with that sRGB code value.
void draw_grey(Extent frame, int grey_level);

}  // namespace obscura::app::kiosk
