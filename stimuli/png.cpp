// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/png.h"

#include "renderer/base/error.h"
#include "renderer/images/images.h"

namespace obscura::stimuli {

std::string encode_png(const RgbImage& image) {
    const auto pixels = static_cast<std::size_t>(image.width) * image.height;
    if (image.rgb.size() != 3 * pixels) {
        throw base::failure("a {}x{} image has {} bytes, not {}", image.width, image.height,
                            image.rgb.size(), 3 * pixels);
    }
    images::Bytes file{image.width, image.height, 3, 3, image.rgb.data()};
    file.is_srgb = true;
    std::string why;
    std::string bytes = images::library().png(file, why);
    if (bytes.empty()) {
        throw base::failure("a {}x{} image could not be encoded as PNG: {}", image.width,
                            image.height, why);
    }
    return bytes;
}

RgbImage decode_png(std::string_view bytes, const std::string& name) {
    std::string why;
    const std::unique_ptr<images::Reader> reader = images::library().open(bytes, "png", why);
    if (!reader) throw base::bad_input("{} is no PNG image: {}", name, why);
    if (reader->channels.size() != 3 || reader->value_type != "uint8") {
        throw base::bad_input("{} has {} channels of {}; a stimulus has 3 of 8 bits", name,
                              reader->channels.size(), reader->value_type);
    }
    RgbImage image{reader->width, reader->height, {}};
    image.rgb.resize(3 * static_cast<std::size_t>(image.width) *
                     static_cast<std::size_t>(image.height));
    if (!reader->read_bytes(3, image.rgb.data(), 3, why)) {
        throw base::bad_input("{} cannot be read: {}", name, why);
    }
    return image;
}

}  // namespace obscura::stimuli
