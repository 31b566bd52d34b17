// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/exr.h"

#include "renderer/base/error.h"
#include "renderer/images/images.h"

namespace obscura::renderer {
const std::vector<float>* FloatImage::find(std::string_view channel) const {
    for (const Channel& candidate : channels) {
        if (candidate.name == channel) return &candidate.values;
    }
    return nullptr;
}

std::string encode_exr(const FloatImage& image) {
    const std::size_t count = image.channels.size();
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::vector<float> interleaved(count * pixels);
    for (std::size_t c = 0; c < count; ++c) {
        for (std::size_t i = 0; i < pixels; ++i) {
            interleaved[i * count + c] = image.channels[c].values.at(i);
        }
    }
    images::Floats file{image.width, image.height, {}, interleaved.data(), {}};
    for (const FloatImage::Channel& channel : image.channels) file.channels.push_back(channel.name);
    file.attributes = {image.texts, image.matrices};
    std::string why;
    std::string bytes = images::library().exr(file, why);
    if (bytes.empty()) {
        throw base::failure("a {}x{} image could not be encoded as OpenEXR: {}", image.width,
                            image.height, why);
    }
    return bytes;
}

FloatImage decode_exr(std::string_view bytes, const std::string& name) {
    std::string why;
    const std::unique_ptr<images::Reader> reader = images::library().open(bytes, "exr", why);
    if (!reader) throw base::bad_input("{} is no OpenEXR image: {}", name, why);
    FloatImage image;
    image.width = reader->width;
    image.height = reader->height;
    const std::size_t count = reader->channels.size();
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::vector<float> interleaved(count * pixels);
    if (!reader->read_floats(static_cast<int>(count), interleaved.data(), why)) {
        throw base::bad_input("{} cannot be read: {}", name, why);
    }
    for (std::size_t c = 0; c < count; ++c) {
        FloatImage::Channel channel{reader->channels[c], std::vector<float>(pixels)};
        for (std::size_t i = 0; i < pixels; ++i) channel.values[i] = interleaved[i * count + c];
        image.channels.push_back(std::move(channel));
    }
    images::Attributes attributes = reader->attributes();
    image.texts = std::move(attributes.texts);
    image.matrices = std::move(attributes.matrices);
    return image;
}

}  // namespace obscura::renderer
