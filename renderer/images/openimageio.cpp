// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>

#include "renderer/images/images.h"

namespace obscura::images {
namespace {

const OIIO::TypeDesc kMatrix(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::MATRIX44);
constexpr const char* kThumbnailFormat = "jpeg:90";

class OpenedReader : public Reader {
  public:
    /// Of a file's bytes; of the file of that name where `bytes` is null.
    static std::unique_ptr<Reader> open(const std::string_view* bytes, const std::string& name,
                                        std::string& why) {
        auto reader = std::make_unique<OpenedReader>();
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        OIIO::Filesystem::IOProxy* proxy = nullptr;
        if (bytes != nullptr) {
            reader->memory_ = std::make_unique<OIIO::Filesystem::IOMemReader>(
                const_cast<char*>(bytes->data()), bytes->size());
            proxy = reader->memory_.get();
            config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
        }
        reader->input_ = OIIO::ImageInput::open(name, &config);
        if (!reader->input_) {
            why = OIIO::geterror();
            return nullptr;
        }
        const OIIO::ImageSpec& spec = reader->input_->spec();
        reader->width = spec.width;
        reader->height = spec.height;
        reader->channels = spec.channelnames;
        reader->channels.resize(static_cast<std::size_t>(std::max(spec.nchannels, 0)));
        reader->value_type = spec.format.c_str();
        return reader;
    }

    bool read_bytes(int count, std::uint8_t* values, int step, std::string& why) override {
        return read(count, OIIO::TypeDesc::UINT8, values, step, why);
    }

    bool read_floats(int count, float* values, std::string& why) override {
        return read(count, OIIO::TypeDesc::FLOAT, values, OIIO::AutoStride, why);
    }

    [[nodiscard]] Attributes attributes() const override {
        Attributes attributes;
        for (const OIIO::ParamValue& attribute : input_->spec().extra_attribs) {
            const std::string key = attribute.name().string();
            if (attribute.type() == OIIO::TypeDesc::STRING) {
                attributes.texts[key] = attribute.get_string();
            } else if (attribute.type() == kMatrix) {
                std::memcpy(attributes.matrices[key].data(), attribute.data(), 16 * sizeof(float));
            }
        }
        return attributes;
    }

  private:
    bool read(int count, OIIO::TypeDesc type, void* values, OIIO::stride_t step, std::string& why) {
        if (input_->read_image(0, 0, 0, count, type, values, step)) return true;
        why = input_->geterror();
        return false;
    }

    std::unique_ptr<OIIO::Filesystem::IOMemReader> memory_;
    std::unique_ptr<OIIO::ImageInput> input_;
};

/// The file's bytes; empty with the reason.
std::string encoded(const std::string& name, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                    const void* values, OIIO::stride_t step, std::string& why) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(name);
    if (!output || !output->set_ioproxy(&memory) || !output->open(name, spec) ||
        !output->write_image(type, values, step) || !output->close()) {
        why = output ? output->geterror() : OIIO::geterror();
        return {};
    }
    return {bytes.begin(), bytes.end()};
}

OIIO::ImageSpec spec_of(const Floats& image) {
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames = image.channels;
    spec.alpha_channel = -1;
    spec.z_channel = -1;
    spec.attribute("compression", "zip");
    for (const auto& [key, text] : image.attributes.texts) spec.attribute(key, text);
    for (const auto& [key, matrix] : image.attributes.matrices) {
        spec.attribute(key, kMatrix, matrix.data());
    }
    return spec;
}

OIIO::ImageBuf wrapped(const float* values, int width, int height) {
    OIIO::ImageBuf buffer(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT));
    buffer.set_pixels(OIIO::ROI(0, width, 0, height, 0, 1, 0, 3), OIIO::TypeDesc::FLOAT, values);
    return buffer;
}

/// Three channels, sRGB code values over 1; empty with the reason.
OIIO::ImageBuf colours_of(std::string_view png, std::string& why) {
    OIIO::Filesystem::IOMemReader reader(const_cast<char*>(png.data()), png.size());
    // The name tells what kind of file the bytes are.
    OIIO::ImageBuf file("stimulus.png", 0, 0, nullptr, nullptr, &reader);
    OIIO::ImageBuf image;
    if (png.empty() || !file.read(0, 0, true, OIIO::TypeDesc::FLOAT) || file.spec().nchannels < 3 ||
        !OIIO::ImageBufAlgo::channels(image, file, 3, {})) {
        why = "no RGB image (" + (file.has_error() ? file.geterror() : image.geterror()) + ")";
        return {};
    }
    return image;
}

class OpenImageIo : public Library {
  public:
    [[nodiscard]] std::unique_ptr<Reader> open(std::string_view bytes, const std::string& ending,
                                               std::string& why) const override {
        return OpenedReader::open(&bytes, "image." + ending, why);
    }

    [[nodiscard]] std::unique_ptr<Reader> open(const std::filesystem::path& file,
                                               std::string& why) const override {
        return OpenedReader::open(nullptr, file.string(), why);
    }

    [[nodiscard]] std::string png(const Bytes& image, std::string& why) const override {
        OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
        if (image.is_srgb) spec.attribute("oiio:ColorSpace", "sRGB");
        if (image.channels == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
        if (image.compression >= 0) spec.attribute("png:compressionLevel", image.compression);
        return encoded("image.png", spec, OIIO::TypeDesc::UINT8, image.values, image.step, why);
    }

    [[nodiscard]] std::string exr(const Floats& image, std::string& why) const override {
        return encoded("image.exr", spec_of(image), OIIO::TypeDesc::FLOAT, image.values,
                       OIIO::AutoStride, why);
    }

    [[nodiscard]] bool write(const std::filesystem::path& file, const Floats& image,
                             std::string& why) const override {
        const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file.string());
        if (output && output->open(file.string(), spec_of(image)) &&
            output->write_image(OIIO::TypeDesc::FLOAT, image.values) && output->close()) {
            return true;
        }
        why = output ? output->geterror() : OIIO::geterror();
        return false;
    }

    [[nodiscard]] std::string thumbnail(std::string_view png, int width_px,
                                        std::string& why) const override {
        const OIIO::ImageBuf image = colours_of(png, why);
        if (!image.initialized()) return {};
        const OIIO::ImageSpec& spec = image.spec();
        const int width = std::min(width_px, spec.width);
        const int height = std::max(1, (spec.height * width + spec.width / 2) / spec.width);
        OIIO::ImageBuf light;
        OIIO::ImageBuf small;
        OIIO::ImageBuf result;
        if (!OIIO::ImageBufAlgo::colorconvert(light, image, "sRGB", "linear") ||
            !OIIO::ImageBufAlgo::resize(small, light, "box", 0.0F,
                                        OIIO::ROI(0, width, 0, height, 0, 1, 0, 3)) ||
            !OIIO::ImageBufAlgo::colorconvert(result, small, "linear", "sRGB")) {
            why = light.geterror() + small.geterror() + result.geterror();
            return {};
        }
        // What a file says of itself (dates, software) is left out, so that bytes follow from
        // pixels.
        OIIO::ImageBuf plain(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT));
        OIIO::ImageBufAlgo::copy(plain, result);
        std::vector<unsigned char> bytes;
        OIIO::Filesystem::IOVecOutput writer(bytes);
        plain.specmod().attribute("compression", kThumbnailFormat);
        plain.specmod().attribute("jpeg:subsampling", "4:4:4");
        plain.set_write_ioproxy(&writer);
        if (!plain.write("thumbnail.jpg", OIIO::TypeDesc::UINT8)) {
            why = plain.geterror();
            return {};
        }
        return {bytes.begin(), bytes.end()};
    }

    [[nodiscard]] Difference difference(const float* a, const float* b, int width,
                                        int height) const override {
        const OIIO::ImageBufAlgo::CompareResults compared = OIIO::ImageBufAlgo::compare(
            wrapped(a, width, height), wrapped(b, width, height), 0.0F, 0.0F);
        return {compared.rms_error, compared.maxerror};
    }

    [[nodiscard]] int yee_failed(const float* a, const float* b, int width, int height,
                                 float luminance_cd_m2, float field_deg) const override {
        OIIO::ImageBufAlgo::CompareResults compared{};
        return OIIO::ImageBufAlgo::compare_Yee(wrapped(a, width, height), wrapped(b, width, height),
                                               compared, luminance_cd_m2, field_deg);
    }
};

}  // namespace
}  // namespace obscura::images

/// What images.cpp asks the module for.
extern "C" __attribute__((visibility("default"))) const obscura::images::Library& obscura_images() {
    static const obscura::images::OpenImageIo library;
    return library;
}
