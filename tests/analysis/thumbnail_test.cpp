// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/thumbnail.h"

#include <gmock/gmock.h>

#include <vector>

#include "renderer/base/error.h"
#include "renderer/images/images.h"

namespace obscura::analysis {
namespace {

/// A PNG whose columns alternate between two grey code values.
std::string stripes(int width, int height, unsigned char one, unsigned char other) {
    std::vector<unsigned char> pixels;
    for (int i = 0; i < width * height; ++i) {
        for (int c = 0; c < 3; ++c) pixels.push_back(i % width % 2 == 0 ? one : other);
    }
    std::string why;
    return images::library().png({width, height, 3, 3, pixels.data()}, why);
}

struct Decoded {
    int width = 0;
    int height = 0;
    std::vector<float> values;
    [[nodiscard]] float green(int x, int y) const {
        return values[3 * static_cast<std::size_t>(y * width + x) + 1];
    }
};

Decoded decoded(const std::string& bytes) {
    std::string why;
    const std::unique_ptr<images::Reader> reader = images::library().open(bytes, "jpg", why);
    if (!reader) throw std::runtime_error(why);
    Decoded image{reader->width, reader->height, {}};
    image.values.resize(3 * static_cast<std::size_t>(image.width * image.height));
    EXPECT_TRUE(reader->read_floats(3, image.values.data(), why)) << why;
    return image;
}

TEST(Thumbnail, AveragesLightAndNotCodeValues) {
    // Half black and half white is half the light: sRGB code value 188 (IEC 61966-2-1), not 128.
    const Decoded image = decoded(thumbnail(stripes(64, 32, 0, 255), "stripes", 16));
    EXPECT_EQ(image.width, 16);
    EXPECT_EQ(image.height, 8);
    EXPECT_NEAR(image.green(8, 4) * 255.0F, 188.0F, 2.0F);
}

TEST(Thumbnail, KeepsASmallImagesSizeAndItsGrey) {
    const Decoded image = decoded(thumbnail(stripes(24, 10, 128, 128), "grey", 600));
    EXPECT_EQ(image.width, 24);
    EXPECT_EQ(image.height, 10);
    EXPECT_NEAR(image.green(12, 5) * 255.0F, 128.0F, 1.5F);
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
