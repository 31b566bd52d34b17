// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/canvas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace obscura::app::explorer {
namespace {

using Area = Canvas::Area;
using Windows = std::vector<Canvas::Drawn>;

const glm::ivec2 kSize{200, 100};
const Area kAll{{0, 0}, kSize};
const Area kLeft{{0, 0}, {100, 100}};
const Area kRight{{100, 0}, {200, 100}};

TEST(ExplorerCanvas, DrawsAgainWhatLooksOtherwiseOrShowsPictures) {
    const Windows before{{"view", 1, true, kLeft}, {"side", 2, false, kRight}};
    EXPECT_THAT(Canvas::changed(before, before, kSize), testing::ElementsAre(kLeft));
    Windows now = before;
    now[1].looks = 3;
    EXPECT_THAT(Canvas::changed(before, now, kSize), testing::ElementsAre(kLeft, kRight));
}

TEST(ExplorerCanvas, DrawsWhereAWindowWasAndWhereItIs) {
    const Windows before{{"view", 1, false, kLeft}, {"help", 2, false, {{10, 10}, {20, 20}}}};
    Windows now = before;
    now[1].area = {{30, 30}, {40, 40}};
    EXPECT_THAT(Canvas::changed(before, now, kSize),
                testing::ElementsAre(before[1].area, now[1].area));
}

TEST(ExplorerCanvas, DrawsEverythingWhenWindowsComeGoOrTakeAnotherOrder) {
    const Windows before{{"view", 1, false, kLeft}, {"side", 2, false, kRight}};
    EXPECT_THAT(Canvas::changed({}, before, kSize), testing::ElementsAre(kAll));
    EXPECT_THAT(Canvas::changed(before, {before[0]}, kSize), testing::ElementsAre(kAll));
    EXPECT_THAT(Canvas::changed(before, {before[1], before[0]}, kSize), testing::ElementsAre(kAll));
    EXPECT_TRUE(Canvas::changed(before, before, kSize).empty());
}

}  // namespace
}  // namespace obscura::app::explorer
