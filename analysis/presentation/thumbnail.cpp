// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/thumbnail.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <vector>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr const char* kFormat = "jpeg:90";

/// Three channels, sRGB code values over 1.
OIIO::ImageBuf read_image(std::string_view bytes, const std::string& name) {
    OIIO::Filesystem::IOMemReader reader(const_cast<char*>(bytes.data()), bytes.size());
    // The name tells OpenImageIO what kind of file the bytes are.
    OIIO::ImageBuf file("stimulus.png", 0, 0, nullptr, nullptr, &reader);
    OIIO::ImageBuf image;
    if (bytes.empty() || !file.read(0, 0, true, OIIO::TypeDesc::FLOAT) ||
        file.spec().nchannels < 3 || !OIIO::ImageBufAlgo::channels(image, file, 3, {})) {
        throw base::bad_input("{}: no RGB image ({})", name,
                              file.has_error() ? file.geterror() : image.geterror());
    }
    return image;
}

std::string written(OIIO::ImageBuf& image, const std::string& name) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput writer(bytes);
    image.specmod().attribute("compression", kFormat);
    image.specmod().attribute("jpeg:subsampling", "4:4:4");
    image.set_write_ioproxy(&writer);
    if (!image.write("thumbnail.jpg", OIIO::TypeDesc::UINT8)) {
        throw base::failure("{}: no thumbnail can be made: {}", name, image.geterror());
    }
    return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string thumbnail(std::string_view image_file, const std::string& name, int width_px) {
    const OIIO::ImageBuf image = read_image(image_file, name);
    const int width = std::min(width_px, image.spec().width);
    const int height =
        std::max(1, (image.spec().height * width + image.spec().width / 2) / image.spec().width);
    OIIO::ImageBuf light;
    OIIO::ImageBuf small;
    OIIO::ImageBuf result;
    if (!OIIO::ImageBufAlgo::colorconvert(light, image, "sRGB", "linear") ||
        !OIIO::ImageBufAlgo::resize(small, light, "box", 0.0F,
                                    OIIO::ROI(0, width, 0, height, 0, 1, 0, 3)) ||
        !OIIO::ImageBufAlgo::colorconvert(result, small, "linear", "sRGB")) {
        throw base::failure("{}: no thumbnail can be made: {}{}{}", name, light.geterror(),
                            small.geterror(), result.geterror());
    }
    // What a file says of itself (dates, software) is left out, so that bytes follow from pixels.
    OIIO::ImageBuf plain(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT));
    OIIO::ImageBufAlgo::copy(plain, result);
    return written(plain, name);
}

}  // namespace obscura::analysis
