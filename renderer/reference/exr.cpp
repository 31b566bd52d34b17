// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/exr.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <memory>

#include "renderer/base/error.h"

namespace obscura::renderer {
namespace {

const OIIO::TypeDesc kMatrix(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::MATRIX44);

OIIO::ImageSpec spec_of(const FloatImage& image) {
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (const FloatImage::Channel& channel : image.channels) {
        spec.channelnames.push_back(channel.name);
    }
    spec.alpha_channel = -1;
    spec.z_channel = -1;
    spec.attribute("compression", "zip");
    for (const auto& [key, text] : image.texts) spec.attribute(key, text);
    for (const auto& [key, matrix] : image.matrices) spec.attribute(key, kMatrix, matrix.data());
    return spec;
}

}  // namespace

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
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("image.exr");
    if (!output || !output->set_ioproxy(&memory) || !output->open("image.exr", spec_of(image)) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, interleaved.data()) || !output->close()) {
        throw base::failure("a {}x{} image could not be encoded as OpenEXR: {}", image.width,
                            image.height, output ? output->geterror() : OIIO::geterror());
    }
    return {bytes.begin(), bytes.end()};
}

FloatImage decode_exr(std::string_view bytes, const std::string& name) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const std::unique_ptr<OIIO::ImageInput> input =
        OIIO::ImageInput::open("image.exr", nullptr, &memory);
    if (!input) throw base::bad_input("{} is no OpenEXR image: {}", name, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    FloatImage image;
    image.width = spec.width;
    image.height = spec.height;
    const auto count = static_cast<std::size_t>(spec.nchannels);
    const std::size_t pixels =
        static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<float> interleaved(count * pixels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, interleaved.data())) {
        throw base::bad_input("{} cannot be read: {}", name, input->geterror());
    }
    for (std::size_t c = 0; c < count; ++c) {
        FloatImage::Channel channel{spec.channelnames[c], std::vector<float>(pixels)};
        for (std::size_t i = 0; i < pixels; ++i) channel.values[i] = interleaved[i * count + c];
        image.channels.push_back(std::move(channel));
    }
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        const std::string key = attribute.name().string();
        if (attribute.type() == OIIO::TypeDesc::STRING) {
            image.texts[key] = attribute.get_string();
        } else if (attribute.type() == kMatrix) {
            std::memcpy(image.matrices[key].data(), attribute.data(), 16 * sizeof(float));
        }
    }
    return image;
}

}  // namespace obscura::renderer
