// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What a laboratory has beside the screen: facts of the display, and a serial response box on a
// pseudo-terminal.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/kiosk/clock.h"
#include "app/kiosk/display_facts.h"
#include "app/kiosk/response_box.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

std::string error_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const base::Error& error) {
        return error.what();
    }
    return "";
}

TEST(DisplayFacts, VisualAnglesFollowFromDistanceAndSize) {
    // A centimetre at 57.29 cm is a degree; a square as wide as twice its distance is 90 degrees.
    EXPECT_NEAR(visual_angle_deg(1.0, 57.2899616), 1.0, 1e-4);
    EXPECT_DOUBLE_EQ(visual_angle_deg(2.0, 1.0), 90.0);
    DisplayFacts facts;
    facts.viewing_distance_cm = 60.0;
    set_screen_size(facts, "60x33.75");
    const auto screen = nlohmann::json::parse(screen_json(facts, {1920, 1080}, {960, 540}));
    EXPECT_NEAR(screen.at("image_width_deg").get<double>(), 28.0724869, 1e-6);
    EXPECT_NEAR(screen.at("image_height_deg").get<double>(), 16.0094577, 1e-6);
    EXPECT_NEAR(screen.at("pixels_per_degree").get<double>(), 33.5103, 1e-3);
    EXPECT_FALSE(screen.contains("gamma"));
    EXPECT_EQ(screen_json({}, {1920, 1080}, {960, 540}), "");
}

TEST(DisplayFacts, AreKeptByMonitorAndOnlyWhatIsGivenAnewChanges) {
    tests::TemporaryFolder folder;
    EXPECT_EQ(known_displays(folder.path()).monitor, "");
    KnownDisplays displays;
    displays.monitor = "DP-1";
    displays.facts["DP-1"].gamma = 2.2;
    displays.facts["DP-1"].viewing_distance_cm = 57.5;
    keep(folder.path(), displays);
    const KnownDisplays again = known_displays(folder.path());
    EXPECT_EQ(again.monitor, "DP-1");
    DisplayFacts given;
    given.viewing_distance_cm = 70.0;
    const DisplayFacts all = again.facts.at("DP-1").with(given);
    EXPECT_EQ(all.gamma, 2.2);
    EXPECT_EQ(all.viewing_distance_cm, 70.0);
    EXPECT_FALSE(all.luminance_cd_m2.has_value());
}

TEST(DisplayFacts, WhatCannotBeIsRefusedWithOptionOrFileAndWhatIsAllowed) {
    DisplayFacts facts;
    facts.gamma = 22.0;
    EXPECT_EQ(error_of([&] { check(facts); }), "--gamma: 22 is out of range, allowed is 0.5 to 5");
    EXPECT_THAT(error_of([&] { set_screen_size(facts, "60cm"); }),
                HasSubstr("--screen-size 60cm: allowed is"));
    tests::TemporaryFolder folder;
    for (const char* text : {"[]", "{\"monitor\": 1}", "no JSON"}) {
        base::write_file_atomically(folder / "display.json", text);
        EXPECT_THAT(error_of([&] { (void)known_displays(folder.path()); }),
                    HasSubstr("display.json is not what obscura run keeps"));
    }
    base::write_file_atomically(folder / "display.json",
                                "{\"monitors\": {\"DP-1\": {\"gamma\": 99}}}");
    EXPECT_THAT(error_of([&] { (void)known_displays(folder.path()); }),
                HasSubstr("DP-1: gamma: 99 is out of range"));
}

/// The far end of a serial line: what is written here the box "sends".
class BoxOnAPty : public testing::Test {
  protected:
    BoxOnAPty() : end_(::posix_openpt(O_RDWR | O_NOCTTY)) {
        EXPECT_EQ(::grantpt(end_), 0);
        EXPECT_EQ(::unlockpt(end_), 0);
        options_.device = ::ptsname(end_);
    }
    ~BoxOnAPty() override { unplug(); }
    void send(const std::string& bytes) const {
        ASSERT_EQ(::write(end_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    void unplug() {
        if (end_ >= 0) ::close(std::exchange(end_, -1));
    }
    /// Waits until so many have come, however slow the machine is.
    static std::vector<ResponseBox::Press> take(ResponseBox& box, std::size_t count) {
        std::vector<ResponseBox::Press> presses;
        for (int i = 0; i < 2000 && presses.size() < count; ++i) {
            for (auto& press : box.take()) presses.push_back(press);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return presses;
    }

    int end_;
    ResponseBoxOptions options_;
};

TEST_F(BoxOnAPty, EachLineIsAKeyStampedWhenItCame) {
    add_box_key(options_, "B1=left");
    add_box_key(options_, "x=y=right");  // the line "x=y"
    std::atomic<int> woken{0};
    ResponseBox box(options_, [&] { ++woken; });
    const double before_s = monotonic_s();
    send("B1\r\nA\n");
    send("spa");
    send("ce\nnonsense\nx=y\r7\n");
    const auto presses = take(box, 5);
    ASSERT_THAT(presses, SizeIs(5));
    EXPECT_EQ(presses[0].key, "left");
    EXPECT_EQ(presses[1].key, "a");
    EXPECT_EQ(presses[2].key, "space");
    EXPECT_EQ(presses[3].key, "right");
    EXPECT_EQ(presses[4].key, "7");
    EXPECT_GE(presses[0].time_s, before_s);
    EXPECT_GE(presses[4].time_s, presses[0].time_s);
    EXPECT_LE(presses[4].time_s, monotonic_s());
    EXPECT_GT(woken, 0);
    EXPECT_FALSE(box.lost());
}

TEST_F(BoxOnAPty, OneThatIsUnpluggedIsLostAndNothingElseHappens) {
    ResponseBox box(options_, [] {});
    unplug();
    for (int i = 0; i < 2000 && !box.lost(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_TRUE(box.lost());
    EXPECT_THAT(box.take(), SizeIs(0));
}

TEST(ResponseBoxOptions, WhatIsNoBoxOrKeyIsRefused) {
    ResponseBoxOptions options;
    EXPECT_THAT(error_of([&] { add_box_key(options, "B1"); }),
                HasSubstr("--box-key B1: allowed is LINE=KEY"));
    EXPECT_THAT(error_of([&] { add_box_key(options, "B1=F13"); }), HasSubstr("--box-key B1=F13"));
    add_box_key(options, "B1=a");
    EXPECT_THAT(error_of([&] { add_box_key(options, "B1=b"); }),
                HasSubstr("that line has a key already, a"));
    const auto open = [&] { const ResponseBox box(options, [] {}); };
    options.device = "/dev/no-such-line";
    EXPECT_THAT(error_of(open), HasSubstr("--response-box /dev/no-such-line: No such file"));
    options.device = "/dev/null";
    EXPECT_THAT(error_of(open), HasSubstr("it is no serial line"));
    options.bits_per_s = 9601;
    EXPECT_THAT(error_of(open), HasSubstr("--box-rate 9601: allowed are 1200, 2400"));
}

}  // namespace
}  // namespace obscura::app::kiosk
