// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/stimulus_view.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
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
    const int left = (frame.width - extent_.width) / 2;
    const int bottom = (frame.height - extent_.height) / 2;
    glBlitNamedFramebuffer(framebuffer_.name(), 0, 0, 0, extent_.width, extent_.height, left,
                           bottom, left + extent_.width, bottom + extent_.height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
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
