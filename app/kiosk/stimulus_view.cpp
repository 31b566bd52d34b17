// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/stimulus_view.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <epoxy/gl.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"

namespace obscura::app::kiosk {
namespace {

constexpr int kChannels = 4;
constexpr float kCodeValues = 255.0F;

/// The image's channels as they are stored, rows from the top.
[[nodiscard]] std::vector<std::uint8_t> decode(const std::string& name, std::string& bytes,
                                               Extent extent, int& channels) {
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    OIIO::ImageSpec as_stored;
    as_stored["oiio:UnassociatedAlpha"] = 1;
    const auto input = OIIO::ImageInput::open(name, &as_stored, &memory);
    if (!input) throw base::bad_input("{} is no image: {}", name, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width != extent.width || spec.height != extent.height) {
        throw base::bad_input("{} is {}x{}, the study's images are {}x{}", name, spec.width,
                              spec.height, extent.width, extent.height);
    }
    if (spec.format != OIIO::TypeDesc::UINT8) {
        throw base::bad_input("{} has {} channels, stimuli have 8 bits", name, spec.format.c_str());
    }
    channels = spec.nchannels;
    std::vector<std::uint8_t> pixels(spec.image_pixels() * static_cast<std::size_t>(channels));
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, pixels.data())) {
        throw base::bad_input("{} cannot be read: {}", name, input->geterror());
    }
    return pixels;
}

}  // namespace

StimulusPixels load_stimulus(const std::filesystem::path& folder, const StimulusImage& image,
                             Extent extent) {
    const std::filesystem::path path = folder / image.file;
    std::string bytes = base::read_file(path);
    if (const std::string hash = base::sha256_hex(bytes); hash != image.sha256) {
        throw base::bad_input("{} has the SHA-256 {}, the manifest says {}", path.string(), hash,
                              image.sha256);
    }
    int channels = 0;
    const auto stored = decode(path.string(), bytes, extent, channels);
    StimulusPixels pixels{extent, {}};
    const auto width = static_cast<std::size_t>(extent.width);
    const auto height = static_cast<std::size_t>(extent.height);
    pixels.rgba.assign(width * height * kChannels, 255);
    for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t column = 0; column < width; ++column) {
            const std::uint8_t* from =
                &stored[(row * width + column) * static_cast<std::size_t>(channels)];
            std::uint8_t* to = &pixels.rgba[((height - 1 - row) * width + column) * kChannels];
            for (int channel = 0; channel < 3; ++channel) {
                to[channel] = from[channels >= 3 ? channel : 0];
            }
        }
    }
    return pixels;
}

StimulusTexture::StimulusTexture(const StimulusPixels& pixels) : extent_(pixels.extent) {
    glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
    glTextureStorage2D(texture_, 1, GL_RGBA8, extent_.width, extent_.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glTextureSubImage2D(texture_, 0, 0, 0, extent_.width, extent_.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels.rgba.data());
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    glFinish();
}

StimulusTexture::~StimulusTexture() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void StimulusTexture::draw(Extent frame, int grey_level) const {
    draw_grey(frame, grey_level);
    const int left = (frame.width - extent_.width) / 2;
    const int bottom = (frame.height - extent_.height) / 2;
    glBlitNamedFramebuffer(framebuffer_, 0, 0, 0, extent_.width, extent_.height, left, bottom,
                           left + extent_.width, bottom + extent_.height, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
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
