// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "renderer/base/error.h"

namespace obscura::stimuli {

std::string encode_png(const RgbImage& image) {
    const auto pixels = static_cast<std::size_t>(image.width) * image.height;
    if (image.rgb.size() != 3 * pixels) {
        throw base::failure("a {}x{} image has {} bytes, not {}", image.width, image.height,
                            image.rgb.size(), 3 * pixels);
    }
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("image.png");
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (!output || !output->set_ioproxy(&memory) || !output->open("image.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, image.rgb.data()) || !output->close()) {
        throw base::failure("a {}x{} image could not be encoded as PNG: {}", image.width,
                            image.height, output ? output->geterror() : OIIO::geterror());
    }
    return {bytes.begin(), bytes.end()};
}

RgbImage decode_png(std::string_view bytes, const std::string& name) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const std::unique_ptr<OIIO::ImageInput> input =
        OIIO::ImageInput::open("image.png", nullptr, &memory);
    if (!input) throw base::bad_input("{} is no PNG image: {}", name, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.nchannels != 3 || spec.format != OIIO::TypeDesc::UINT8) {
        throw base::bad_input("{} has {} channels of {}; a stimulus has 3 of 8 bits", name,
                              spec.nchannels, spec.format.c_str());
    }
    RgbImage image{spec.width, spec.height, {}};
    image.rgb.resize(3 * static_cast<std::size_t>(spec.width) * spec.height);
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, image.rgb.data())) {
        throw base::bad_input("{} cannot be read: {}", name, input->geterror());
    }
    return image;
}

}  // namespace obscura::stimuli
