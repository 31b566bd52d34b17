// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/timing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using testing::HasSubstr;

SelfTest a_self_test() {
    return {"2026-11-27T00:00:00Z",
            "a monitor",
            "a GPU",
            "a clock",
            60.0,
            16.67,
            true,
            100.0,
            {200, 0.1, 0.2, -0.9},
            0,
            {50, 9.0, 4.0, 18.0}};
}

TEST(Timing, FiguresAreThoseOfASample) {
    const Figures figures = figures_of({1.0, -4.0, 3.0, 2.0});
    EXPECT_EQ(figures.count, 4);
    EXPECT_DOUBLE_EQ(figures.mean, 0.5);
    EXPECT_NEAR(figures.sd, 3.1091263510296048, 1e-12);  // R: sd(c(1, -4, 3, 2))
    EXPECT_DOUBLE_EQ(figures.worst, -4.0);
    EXPECT_EQ(figures_of({}), Figures{});
    EXPECT_EQ(figures_of({2.0}), (Figures{1, 2.0, 0.0, 2.0}));
}

TEST(Timing, TheLastSelfTestIsReadAsItWasKeptAndNothingElseIs) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(last_self_test(folder.path()), std::nullopt);
    const auto file = self_test_file(folder.path());
    std::filesystem::create_directories(file.parent_path());
    base::write_file_atomically(file, to_json(a_self_test()));
    EXPECT_EQ(last_self_test(folder.path()), a_self_test());
    for (const char* other : {"", "{}", "[1]", R"({"time_utc": 3})"}) {
        base::write_file_atomically(file, other);
        try {
            (void)last_self_test(folder.path());
            ADD_FAILURE() << other;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            EXPECT_THAT(error.what(), HasSubstr("obscura run --selftest"));
        }
    }
}

TEST(Timing, IntervalsAreReliedOnOnlyWhereSwappingWaitsAndNoFrameIsLate) {
    EXPECT_TRUE(a_self_test().holds());
    SelfTest late = a_self_test();
    late.dropped_frames = 1;
    EXPECT_THAT(to_text(late), HasSubstr("cannot be relied on"));
    SelfTest loose = a_self_test();
    loose.waits = false;
    EXPECT_FALSE(loose.holds());
}

TEST(Timing, ASessionCarriesTheSourceOfItsTimesAndTheLastSelfTest) {
    const auto with = nlohmann::json::parse(session_timing("a clock", 16.7, true, a_self_test()));
    EXPECT_EQ(with.at("source"), "a clock");
    EXPECT_EQ(with.at("self_test").at("error_ms").at("worst"), -0.9);
    const auto without = nlohmann::json::parse(session_timing("a clock", 1.0, false, {}));
    EXPECT_TRUE(without.at("self_test").is_null());
    EXPECT_EQ(without.at("waits"), false);
}

}  // namespace
}  // namespace obscura::app::kiosk
