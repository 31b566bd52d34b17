// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT

// Whether the window is to be seen, on displays with and without a window manager.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/kiosk/clock.h"
#include "app/kiosk/stage.h"
#include "app/kiosk/window.h"
#include "app/window/letters.h"
#include "app/window/theme.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/app/kiosk/virtual_display.h"
// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace obscura::app::kiosk {
namespace {

constexpr double kPatience_s = 40.0;

/// Whether the window comes to be so, within reason.
[[nodiscard]] bool becomes(Window& window, Sight wanted) {
    const double end_s = monotonic_s() + kPatience_s;
    while (monotonic_s() < end_s) {
        window.wait_for_events(0.02);
        if (window.sight() == wanted) return true;
    }
    ADD_FAILURE() << "it is '" << to_string(window.sight()) << "': " << window.state();
    return false;
}

void expect_full_starts(VirtualDisplay& display, int count, Extent size) {
    (void)display;
    for (int start = 0; start < count; ++start) {
        Window window({0, false, {64, 64}});
        EXPECT_EQ(window.size(), size);
        EXPECT_TRUE(becomes(window, Sight::kClear)) << "start " << start;
    }
}

class EveryStart : public testing::TestWithParam<Extent> {};

TEST_P(EveryStart, FillsTheMonitorWithoutAWindowManager) {
    VirtualDisplay display(GetParam().width, GetParam().height);
    expect_full_starts(display, 4, GetParam());
}

TEST_P(EveryStart, FillsTheMonitorUnderAWindowManager) {
    VirtualDisplay display(GetParam().width, GetParam().height);
    display.start_window_manager();
    expect_full_starts(display, 12, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Sight, EveryStart, testing::Values(Extent{1280, 800}, Extent{1920, 1080}),
                         [](const auto& tested) {
                             return fmt::format("{}x{}", tested.param.width, tested.param.height);
                         });

TEST(Sight, AWindowBeforeItCoversItUntilItGoes) {
    const VirtualDisplay display(1024, 768);
    Window window({0, false, {64, 64}});
    ASSERT_TRUE(becomes(window, Sight::kClear));
    {
        const OtherWindow corner(1000, 700, 20, 20);
        EXPECT_TRUE(becomes(window, Sight::kCovered)) << "a corner is enough";
    }
    EXPECT_TRUE(becomes(window, Sight::kClear));
    const OtherWindow whole(0, 0, 1024, 768);
    EXPECT_TRUE(becomes(window, Sight::kCovered));
}

TEST(Sight, AWindowThatTookTheKeysGivesThemBackWhenItIsRestored) {
    for (const bool managed : {false, true}) {
        VirtualDisplay display(1024, 768);
        if (managed) display.start_window_manager();
        Window window({0, false, {64, 64}});
        ASSERT_TRUE(becomes(window, Sight::kClear));
        const OtherWindow other(-20, -20, 10, 10);  // out of sight
        other.take_focus();
        EXPECT_TRUE(becomes(window, Sight::kLostFocus));
        window.restore();
        EXPECT_TRUE(becomes(window, Sight::kClear));
    }
}

TEST(Sight, AnIconifiedWindowIsRestoredToTheWholeMonitor) {
    VirtualDisplay display(1280, 800);
    display.start_window_manager();
    Window window({0, false, {64, 64}});
    ASSERT_TRUE(becomes(window, Sight::kClear));
    display.tool({"xdotool", "search", "--name", "Obscura", "windowminimize"});
    EXPECT_TRUE(becomes(window, Sight::kIconified));
    window.restore();
    EXPECT_TRUE(becomes(window, Sight::kClear));
    EXPECT_EQ(window.size(), (Extent{1280, 800}));
}

TEST(Sight, AResizedWindowIsRestored) {
    for (const bool windowed : {false, true}) {
        VirtualDisplay display(1100, 800);
        Window window({0, windowed, {64, 64}});
        const Extent size = window.size();
        ASSERT_TRUE(becomes(window, Sight::kClear));
        display.tool({"xdotool", "search", "--name", "Obscura", "windowsize", "700", "500"});
        EXPECT_TRUE(becomes(window, Sight::kResized));
        window.restore();
        EXPECT_TRUE(becomes(window, Sight::kClear));
        EXPECT_EQ(window.size(), size);
    }
}

void set_mode(const VirtualDisplay& display, const std::string& mode) {
    display.tool({"xrandr", "--output", "screen", "--mode", mode});
}

TEST(Sight, AMonitorThatChangesItsSizeOrGoesIsNoticedAndTheWindowFillsItWhenItIsBack) {
    for (const bool managed : {false, true}) {
        SCOPED_TRACE(managed ? "under a window manager" : "without a window manager");
        VirtualDisplay display(1280, 800);
        display.tool({"xrandr", "--newmode", "800x600", "0", "800", "800", "800", "800", "600",
                      "600", "600", "600"});
        display.tool({"xrandr", "--addmode", "screen", "800x600"});
        if (managed) display.start_window_manager();
        Window window({0, false, {64, 64}});
        ASSERT_TRUE(becomes(window, Sight::kClear));
        set_mode(display, "800x600");
        EXPECT_TRUE(becomes(window, Sight::kResized));
        EXPECT_THAT(window.state(), testing::HasSubstr("is 800x600, it was 1280x800"));
        window.restore();
        EXPECT_TRUE(becomes(window, Sight::kResized)) << "nothing changes the monitor";
        set_mode(display, "1280x800");
        for (int attempt = 0; attempt < 10 && window.sight() != Sight::kClear; ++attempt) {
            window.restore();
            window.wait_for_events(0.2);
        }
        EXPECT_TRUE(becomes(window, Sight::kClear));
        // The server switches the output off and then refuses a screen without any.
        EXPECT_THROW(display.tool({"xrandr", "--output", "screen", "--off"}), std::runtime_error);
        EXPECT_TRUE(becomes(window, Sight::kMonitorLost));
        window.restore();
        set_mode(display, "1280x800");
        for (int attempt = 0; attempt < 20 && window.sight() != Sight::kClear; ++attempt) {
            window.restore();
            window.wait_for_events(0.2);
        }
        EXPECT_TRUE(becomes(window, Sight::kClear));
        EXPECT_EQ(window.size(), (Extent{1280, 800}));
    }
}

TEST(Letters, AreWhatTheKeysTypeNotWhereTheyAre) {
    const VirtualDisplay display(640, 480);
    const auto become = [&display](Window& window, const char* layout, int key_of_q) {
        display.tool({"setxkbmap", layout});
        const double end_s = monotonic_s() + kPatience_s;
        while (window::key_of_letter('q') != key_of_q && monotonic_s() < end_s) {
            window.wait_for_events(0.02);
            (void)window.sight();
        }
        EXPECT_EQ(window::key_of_letter('q'), key_of_q) << layout;
    };
    {
        Window window({0, false, {64, 64}});
        EXPECT_EQ(window::key_of_letter('q'), GLFW_KEY_Q);
        EXPECT_EQ(window::key_of_letter('l'), GLFW_KEY_L);
        become(window, "fr", GLFW_KEY_A);
        EXPECT_EQ(window::key_of_letter('a'), GLFW_KEY_Q);
        EXPECT_EQ(window::key_of_letter('l'), GLFW_KEY_L);
        become(window, "ru", GLFW_KEY_Q);  // no key types it: by its place
        become(window, "dvorak", GLFW_KEY_X);
        EXPECT_EQ(window::key_of_letter('l'), GLFW_KEY_P);
    }
    const Window window({0, false, {64, 64}});
    EXPECT_EQ(window::key_of_letter('q'), GLFW_KEY_X)
        << "a layout that was there before the window";
}

TEST(Saving, APageStandsOnTheScreenWhileTheStoreTakesItsTime) {
    const VirtualDisplay display(1024, 768);
    Window window({0, false, {64, 64}});
    const stimuli::Study study = small_study(2);
    Ui ui(window, study.words, 128);
    Stage stage{window, ui, study, {}, {}, ""};
    bool page_shown = false;
    // The work ends when the page is to be seen, and not before.
    const int done = done_aside(stage, page_shown, [&display] {
        const auto card = static_cast<int>(window::theme::kCard.x * 255.0F + 0.5F);
        const double end_s = monotonic_s() + kPatience_s;
        while (monotonic_s() < end_s) {
            const stimuli::RgbImage screen = display.screen();
            const auto row = screen.rgb.begin() + 768L / 2 * 1024 * 3;
            if (std::count(row, row + 1024L * 3, card) > 100) return 7;
        }
        return 0;
    });
    EXPECT_EQ(done, 7);
    EXPECT_TRUE(page_shown);
    EXPECT_THROW(
        (void)done_aside(stage, page_shown,
                         []() -> int { throw std::runtime_error("what the work throws"); }),
        std::runtime_error);
}

[[nodiscard]] double luminance(const ImVec4& colour) {
    // WCAG 2.2, relative luminance.
    const auto linear = [](double value) {
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.x) + 0.7152 * linear(colour.y) + 0.0722 * linear(colour.z);
}

[[nodiscard]] double contrast(const ImVec4& one, const ImVec4& other) {
    const auto [low, high] = std::minmax({luminance(one), luminance(other)});
    return (high + 0.05) / (low + 0.05);
}

TEST(Theme, EveryTextHasSevenToOneWithWhatIsBehindIt) {
    using namespace window::theme;
    EXPECT_DOUBLE_EQ(contrast({0, 0, 0, 1}, {1, 1, 1, 1}), 21.0);
    for (const ImVec4& behind : {kCard, kField, kFieldHovered}) {
        EXPECT_GE(contrast(kInk, behind), 7.0);
        EXPECT_GE(contrast(kFaintInk, behind), 7.0);
        EXPECT_GE(contrast(kComplaint, behind), 7.0);
    }
    for (const ImVec4& behind : {kQuiet, kQuietHovered, kQuietPressed}) {
        EXPECT_GE(contrast(kInk, behind), 7.0);
    }
    for (const ImVec4& behind : {kAccent, kAccentHovered, kAccentPressed}) {
        EXPECT_GE(contrast(kOnAccent, behind), 7.0);
    }
}

}  // namespace
}  // namespace obscura::app::kiosk
