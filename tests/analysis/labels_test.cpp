// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/plot/labels.h"

#include <gtest/gtest.h>

#include "renderer/base/random.h"

namespace obscura::analysis {
namespace {

constexpr Box kArea{80.0, 60.0, 880.0, 460.0};

/// Points in a heap, as techniques that cost and err alike lie.
std::vector<PointName> heap_of(int count, std::uint64_t seed) {
    base::Random random(seed);
    std::vector<PointName> names;
    for (int i = 0; i < count; ++i) {
        names.push_back({random.uniform(350.0, 500.0), random.uniform(200.0, 300.0),
                         i % 3 == 0 ? "RayMarching30" : "Gtao16", i % 2 == 0 ? 15.0 : 12.0});
    }
    return names;
}

TEST(Labels, NoTwoTouchAndNoneLeavesThePictureOrHidesWhatIsKeptFree) {
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        const std::vector<PointName> names = heap_of(24, seed);
        const std::vector<Box> kept_free{{380.0, 210.0, 60.0, 40.0}};
        const auto places = places_of(names, kArea, kept_free);
        ASSERT_EQ(places.size(), names.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            ASSERT_TRUE(places[i].has_value()) << seed << ", " << i;
            EXPECT_TRUE(kArea.holds(*places[i]));
            EXPECT_FALSE(places[i]->overlaps(kept_free[0]));
            EXPECT_GE(places[i]->width, room_of(names[i]).width);
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_FALSE(places[i]->overlaps(*places[j])) << seed << ": " << i << ", " << j;
            }
        }
    }
}

TEST(Labels, APointAloneHasItsNameCloseToItsRight) {
    const auto places = places_of({{400.0, 300.0, "Hbao16", 15.0}}, kArea, {});
    ASSERT_TRUE(places[0].has_value());
    EXPECT_GT(places[0]->left, 400.0);
    EXPECT_LT(places[0]->left, 415.0);
    EXPECT_NEAR(places[0]->bottom + 0.5 * places[0]->height, 300.0, 0.5);
}

TEST(Labels, ANameWithoutRoomIsLeftOut) {
    const auto places = places_of({{400.0, 300.0, "Hbao16", 15.0}}, kArea, {kArea});
    EXPECT_FALSE(places[0].has_value());
}

}  // namespace
}  // namespace obscura::analysis
