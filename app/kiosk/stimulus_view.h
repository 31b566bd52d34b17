// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/kiosk/session_plan.h"
#include "app/kiosk/window.h"
#include "renderer/gl/handles.h"
#include "stimuli/study.h"

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
    /// Copies it into the frame, its lower left corner there.
    void copy_to(int left, int bottom) const;
    [[nodiscard]] Extent extent() const { return extent_; }

  private:
    Extent extent_;
    renderer::gl::Texture texture_;
    renderer::gl::Framebuffer framebuffer_;
};

/// The room that two images of that size take side by side.
[[nodiscard]] Extent room_beside(Extent image);

/// Copies two images of one size into the middle of the frame, side by side and pixel for pixel;
/// all around is grey.
void draw_beside(const StimulusTexture& left, const StimulusTexture& right, Extent frame,
                 int grey_level);

/// Squares of any grey of the size of the study's images, the same for the same seed.
[[nodiscard]] StimulusPixels noise_of(const stimuli::Study& study);

/// What fills the interval between two images.
class IntervalView {
  public:
    explicit IntervalView(const stimuli::Study& study);
    void draw(Extent frame) const;

  private:
    void draw_cross(Extent frame) const;

    const stimuli::Study& study_;
    std::unique_ptr<StimulusTexture> mask_;
};

/// Fills the frame with that sRGB code value.
void draw_grey(Extent frame, int grey_level);

}  // namespace obscura::app::kiosk
