// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/stimulus_view.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/random.h"
#include "stimuli/png.h"

namespace obscura::app::kiosk {
namespace {

constexpr int kChannels = 4;
constexpr float kCodeValues = 255.0F;

void require_no_error(Extent extent) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    throw base::failure("the GPU cannot hold an image of {}x{}: OpenGL error 0x{:04X}{}",
                        extent.width, extent.height, error,
                        error == GL_OUT_OF_MEMORY ? " (out of memory)" : "");
}

/// Grey between two images that stand side by side.
[[nodiscard]] int gap_between(Extent image) { return std::max(8, image.width / 40); }

}  // namespace

StimulusPixels load_stimulus(const std::filesystem::path& folder, const StimulusImage& image,
                             Extent extent) {
    const std::filesystem::path path = folder / image.file;
    const std::string bytes = base::read_file(path);
    if (const std::string hash = base::sha256_hex(bytes); hash != image.sha256) {
        throw base::bad_input("{} has the SHA-256 {}, the manifest says {}", path.string(), hash,
                              image.sha256);
    }
    const stimuli::RgbImage stored = stimuli::decode_png(bytes, path.string());
    if (stored.width != extent.width || stored.height != extent.height) {
        throw base::bad_input("{} is {}x{}, the study's images are {}x{}", path.string(),
                              stored.width, stored.height, extent.width, extent.height);
    }
    StimulusPixels pixels{extent, {}};
    const auto width = static_cast<std::size_t>(extent.width);
    const auto height = static_cast<std::size_t>(extent.height);
    pixels.rgba.assign(width * height * kChannels, 255);
    for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t column = 0; column < width; ++column) {
            const std::uint8_t* from = &stored.rgb[(row * width + column) * 3];
            std::uint8_t* to = &pixels.rgba[((height - 1 - row) * width + column) * kChannels];
            std::copy_n(from, 3, to);
        }
    }
    return pixels;
}

StimulusTexture::StimulusTexture(const StimulusPixels& pixels)
    : extent_(pixels.extent),
      texture_(renderer::gl::Texture::make(GL_TEXTURE_2D)),
      framebuffer_(renderer::gl::Framebuffer::make()) {
    const GLuint texture = texture_.name();
    glTextureStorage2D(texture, 1, GL_RGBA8, extent_.width, extent_.height);
    require_no_error(extent_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glTextureSubImage2D(texture, 0, 0, 0, extent_.width, extent_.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels.rgba.data());
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture, 0);
    glFinish();
    require_no_error(extent_);
}

void StimulusTexture::draw(Extent frame, int grey_level) const {
    draw_grey(frame, grey_level);
    copy_to((frame.width - extent_.width) / 2, (frame.height - extent_.height) / 2);
}

void StimulusTexture::copy_to(int left, int bottom) const {
    glBlitNamedFramebuffer(framebuffer_.name(), 0, 0, 0, extent_.width, extent_.height, left,
                           bottom, left + extent_.width, bottom + extent_.height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Extent room_beside(Extent image) { return {2 * image.width + gap_between(image), image.height}; }

void draw_beside(const StimulusTexture& left, const StimulusTexture& right, Extent frame,
                 int grey_level) {
    const Extent image = left.extent();
    const Extent room = room_beside(image);
    const int from = (frame.width - room.width) / 2;
    const int bottom = (frame.height - room.height) / 2;
    draw_grey(frame, grey_level);
    left.copy_to(from, bottom);
    right.copy_to(from + image.width + gap_between(image), bottom);
}

StimulusPixels noise_of(const stimuli::Study& study) {
    constexpr int kSquare = 8;
    const Extent extent{study.width, study.height};
    const int columns = (extent.width + kSquare - 1) / kSquare;
    const int rows = (extent.height + kSquare - 1) / kSquare;
    base::Random random(study.seed);
    std::vector<std::uint8_t> tones(static_cast<std::size_t>(columns) *
                                    static_cast<std::size_t>(rows));
    for (std::uint8_t& tone : tones) tone = static_cast<std::uint8_t>(random.below(256));
    StimulusPixels pixels{extent, {}};
    for (int y = 0; y < extent.height; ++y) {
        for (int x = 0; x < extent.width; ++x) {
            const auto at = static_cast<std::size_t>(y / kSquare * columns + x / kSquare);
            pixels.rgba.insert(pixels.rgba.end(), {tones[at], tones[at], tones[at], 255});
        }
    }
    return pixels;
}

IntervalView::IntervalView(const stimuli::Study& study) : study_(study) {
    if (study.presentation.interval != stimuli::Interval::kMask) return;
    mask_ = std::make_unique<StimulusTexture>(noise_of(study));
}

void IntervalView::draw(Extent frame) const {
    const int grey = study_.presentation.grey_level;
    if (mask_) {
        mask_->draw(frame, grey);
        return;
    }
    draw_grey(frame, grey);
    if (study_.presentation.interval == stimuli::Interval::kFixation) draw_cross(frame);
}

/// Black or white, whichever is farther from the grey.
void IntervalView::draw_cross(Extent frame) const {
    constexpr int kArm = 60;  // of the image's height
    constexpr int kLine = 480;
    const int arm = std::max(4, study_.height / kArm);
    const int line = std::max(2, study_.height / kLine);
    const float tone = study_.presentation.grey_level < 128 ? 1.0F : 0.0F;
    glEnable(GL_SCISSOR_TEST);
    glClearColor(tone, tone, tone, 1.0F);
    const auto fill = [&](int width, int height) {
        glScissor((frame.width - width) / 2, (frame.height - height) / 2, width, height);
        glClear(GL_COLOR_BUFFER_BIT);
    };
    fill(2 * arm + line, line);
    fill(line, 2 * arm + line);
    glDisable(GL_SCISSOR_TEST);
}

void draw_grey(Extent frame, int grey_level) {
    const float grey = static_cast<float>(grey_level) / kCodeValues;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DITHER);
    glViewport(0, 0, frame.width, frame.height);
    glClearColor(grey, grey, grey, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace obscura::app::kiosk
