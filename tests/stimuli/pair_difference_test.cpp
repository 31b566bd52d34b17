// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "renderer/base/error.h"
#include "stimuli/image_difference.h"

namespace obscura::stimuli {
namespace {

using Code = std::array<std::uint8_t, 3>;

RgbImage plain(int width, int height, const Code& code) {
    RgbImage image{width, height, {}};
    image.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = code[i % 3];
    return image;
}

/// Sets the first `count` pixels.
RgbImage with_pixels(RgbImage image, int count, const Code& code) {
    for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(count); ++i) {
        image.rgb[i] = code[i % 3];
    }
    return image;
}

double delta_e(const Code& a, const Code& b) {
    return difference_of(plain(1, 1, a), plain(1, 1, b)).largest_delta_e;
}

TEST(ImageDifference, IsThatOfCielabUnderD65) {
    // L* a* b* of the primaries and of greys, as colour science tables print them.
    EXPECT_NEAR(delta_e({255, 255, 255}, {0, 0, 0}), 100.0, 0.1);
    EXPECT_NEAR(delta_e({119, 119, 119}, {0, 0, 0}), 50.03, 0.1);
    // Red (53.24, 80.09, 67.20), green (87.73, -86.18, 83.18), blue (32.30, 79.19, -107.86).
    EXPECT_NEAR(delta_e({255, 0, 0}, {0, 255, 0}), 170.58, 0.2);
    EXPECT_NEAR(delta_e({0, 0, 255}, {255, 0, 0}), 176.33, 0.2);
    EXPECT_NEAR(delta_e({0, 0, 255}, {0, 255, 0}), 258.69, 0.2);
}

TEST(Brightness, HasTheMeanLuminanceOfSrgbAsAShareOfWhite) {
    EXPECT_NEAR(brightness_of(plain(3, 2, {255, 255, 255})).mean, 1.0, 1e-6);
    EXPECT_NEAR(brightness_of(plain(3, 2, {0, 255, 0})).mean, 0.7152, 1e-6);
    EXPECT_NEAR(brightness_of(plain(1, 1, {188, 188, 188})).mean, 0.5029, 1e-4);  // IEC 61966-2-1
    EXPECT_NEAR(brightness_of(with_pixels(plain(2, 2, {0, 0, 0}), 1, {255, 255, 255})).mean, 0.25,
                1e-6);
}

TEST(Brightness, HasTheContrastOfLuminanceWhateverTheExposure) {
    EXPECT_NEAR(brightness_of(plain(3, 2, {90, 120, 30})).contrast, 0.0, 1e-3);
    EXPECT_EQ(brightness_of(plain(3, 2, {0, 0, 0})).contrast, 0.0);
    // One white pixel of four: deviation sqrt(1/4 - 1/16), mean 1/4.
    EXPECT_NEAR(brightness_of(with_pixels(plain(2, 2, {0, 0, 0}), 1, {255, 255, 255})).contrast,
                std::sqrt(3.0), 1e-5);
    // 137 has a quarter of white's luminance (0.2502).
    EXPECT_NEAR(brightness_of(with_pixels(plain(2, 2, {0, 0, 0}), 1, {137, 137, 137})).contrast,
                std::sqrt(3.0), 1e-5);
}

TEST(ImageDifference, OfACodeValueIsBelowWhatIsNoticedWhereverItLies) {
    for (int code = 0; code < 255; ++code) {
        const auto low = static_cast<std::uint8_t>(code);
        const auto high = static_cast<std::uint8_t>(code + 1);
        EXPECT_LT(delta_e({low, low, low}, {high, high, high}), kJustNoticeable_delta_e) << code;
        EXPECT_LT(delta_e({low, low, low}, {low, low, high}), kJustNoticeable_delta_e) << code;
    }
    const ImageDifference difference =
        difference_of(plain(64, 64, {90, 91, 92}), plain(64, 64, {91, 92, 93}));
    EXPECT_EQ(difference.differing, 1.0);
    EXPECT_FALSE(difference.can_be_seen());
}

TEST(ImageDifference, OfEqualImagesIsNone) {
    const ImageDifference difference =
        difference_of(plain(9, 5, {7, 8, 9}), plain(9, 5, {7, 8, 9}));
    EXPECT_TRUE(difference.none());
    EXPECT_FALSE(difference.can_be_seen());
    EXPECT_EQ(difference.largest_delta_e, 0.0);
}

TEST(ImageDifference, CanBeSeenFromATenThousandthOfTheImageByOneJustNoticeableDifference) {
    const RgbImage grey = plain(400, 250, {128, 128, 128});  // 100,000 pixels
    const Code other{135, 135, 135};
    const double steps = delta_e({128, 128, 128}, other) / kJustNoticeable_delta_e;
    ASSERT_GT(steps, 1.0);
    ASSERT_LT(steps, 1.25);
    EXPECT_FALSE(difference_of(grey, with_pixels(grey, 8, other)).can_be_seen());
    EXPECT_TRUE(difference_of(grey, with_pixels(grey, 10, other)).can_be_seen());
    const ImageDifference some = difference_of(grey, with_pixels(grey, 10, other));
    EXPECT_NEAR(some.over_threshold, 1e-4, 1e-12);
    EXPECT_NEAR(some.visible, 1e-4 * steps, 1e-9);
    // A spot of few pixels needs the more contrast.
    EXPECT_TRUE(difference_of(grey, with_pixels(grey, 1, {255, 255, 255})).can_be_seen());
}

TEST(ImageDifference, IsTheSameEitherWayRound) {
    const RgbImage a = plain(20, 20, {40, 90, 200});
    const RgbImage b = with_pixels(a, 30, {60, 80, 190});
    EXPECT_EQ(difference_of(a, b), difference_of(b, a));
}

TEST(ImageDifference, OfImagesOfDifferentSizesIsRefused) {
    EXPECT_THROW((void)difference_of(plain(2, 2, {}), plain(4, 1, {})), base::Error);
    EXPECT_THROW((void)difference_of({}, {}), base::Error);
}

}  // namespace
}  // namespace obscura::stimuli
