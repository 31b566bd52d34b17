// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/thumbnail.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gmock/gmock.h>

#include <vector>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

/// A PNG whose columns alternate between two grey code values.
std::string stripes(int width, int height, unsigned char one, unsigned char other) {
    std::vector<unsigned char> pixels;
    for (int i = 0; i < width * height; ++i) {
        for (int c = 0; c < 3; ++c) pixels.push_back(i % width % 2 == 0 ? one : other);
    }
    OIIO::ImageBuf image(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8));
    image.set_pixels(image.roi(), OIIO::TypeDesc::UINT8, pixels.data());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput writer(bytes);
    image.set_write_ioproxy(&writer);
    EXPECT_TRUE(image.write("stripes.png"));
    return {bytes.begin(), bytes.end()};
}

OIIO::ImageBuf decoded(const std::string& bytes) {
    OIIO::Filesystem::IOMemReader reader(const_cast<char*>(bytes.data()), bytes.size());
    OIIO::ImageBuf image("thumbnail.jpg", 0, 0, nullptr, nullptr, &reader);
    EXPECT_TRUE(image.read(0, 0, true, OIIO::TypeDesc::FLOAT));
    return image;
}

TEST(Thumbnail, AveragesLightAndNotCodeValues) {
    // Half black and half white is half the light: sRGB code value 188 (IEC 61966-2-1), not 128.
    const OIIO::ImageBuf image = decoded(thumbnail(stripes(64, 32, 0, 255), "stripes", 16));
    EXPECT_EQ(image.spec().width, 16);
    EXPECT_EQ(image.spec().height, 8);
    EXPECT_NEAR(image.getchannel(8, 4, 0, 1) * 255.0F, 188.0F, 2.0F);
}

TEST(Thumbnail, KeepsASmallImagesSizeAndItsGrey) {
    const OIIO::ImageBuf image = decoded(thumbnail(stripes(24, 10, 128, 128), "grey", 600));
    EXPECT_EQ(image.spec().width, 24);
    EXPECT_EQ(image.spec().height, 10);
    EXPECT_NEAR(image.getchannel(12, 5, 0, 1) * 255.0F, 128.0F, 1.5F);
}

TEST(Thumbnail, IsTheSameBytesAgain) {
    const std::string png = stripes(40, 20, 10, 200);
    EXPECT_EQ(thumbnail(png, "one", 20), thumbnail(png, "two", 20));
}

TEST(Thumbnail, RefusesWhatIsNoImage) {
    for (const std::string& bytes :
         {std::string(), std::string("no image"), stripes(40, 20, 10, 200).substr(0, 60)}) {
        try {
            (void)thumbnail(bytes, "III-a.png", 20);
            ADD_FAILURE() << "accepted";
        } catch (const base::Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("III-a.png"));
        }
    }
}

}  // namespace
}  // namespace obscura::analysis
