// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/window.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <cstdlib>

#include "app/kiosk/pace.h"
#include "app/kiosk/self_test.h"
#include "app/kiosk/stimulus_view.h"
#include "app/kiosk/ui.h"
#include "renderer/base/error.h"
#include "tests/app/kiosk/shown_study.h"
#include "tests/app/kiosk/virtual_display.h"

namespace obscura::app::kiosk {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr Extent kImages{ShownStudy::kWidth, ShownStudy::kHeight};

/// What was drawn and not yet presented, upper row first.
stimuli::RgbImage read_back(Extent size) {
    stimuli::RgbImage image{size.width, size.height, {}};
    image.rgb.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                     3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int row = 0; row < size.height; ++row) {
        glReadPixels(0, size.height - 1 - row, size.width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                     &image.rgb[static_cast<std::size_t>(row * size.width * 3)]);
    }
    return image;
}

template <typename Action>
std::string message_of(base::ExitCode code, const Action& action) {
    try {
        action();
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), code);
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return "";
}

TEST(KioskWindow, EveryByteOnTheScreenIsTheFilesAndAllAroundIsGrey) {
    const ShownStudy shown(3, 2000);
    const VirtualDisplay display(801, 603);  // odd differences: the middle is rounded
    Window window({0, false, kImages});
    const Extent size = window.size();
    ASSERT_EQ(size.width, 801);
    ASSERT_EQ(size.height, 603);
    for (const stimuli::ManifestImage& entry : shown.manifest.images) {
        const StimulusTexture texture(
            load_stimulus(shown.folder, {entry.file, entry.sha256}, kImages));
        texture.draw(size, 128);
        const stimuli::RgbImage& image = shown.images.at(entry.sha256);
        // glBlit counts rows from below, so the rounded row is the other one.
        stimuli::RgbImage drawn = read_back(size);
        drawn.rgb.erase(drawn.rgb.begin(), drawn.rgb.begin() + 3L * size.width);
        EXPECT_EQ(wrong_pixels(drawn, &image, size.width, size.height - 1, 128), 0) << entry.file;
        window.present();
        window.poll_events();
        stimuli::RgbImage seen = display.screen();
        seen.rgb.erase(seen.rgb.begin(), seen.rgb.begin() + 3L * size.width);
        EXPECT_EQ(wrong_pixels(seen, &image, size.width, size.height - 1, 128), 0) << entry.file;
    }
    for (const int grey : {0, 1, 127, 128, 254, 255}) {
        draw_grey(size, grey);
        EXPECT_EQ(wrong_pixels(read_back(size), nullptr, size.width, size.height, grey), 0);
    }
}

TEST(KioskWindow, AnImageThatIsNotTheManifestsIsNotShown) {
    const ShownStudy shown(2, 2000);
    const stimuli::ManifestImage& image = shown.manifest.images[1];
    const std::string tampered = message_of(base::ExitCode::kBadInput, [&] {
        (void)load_stimulus(shown.folder, {image.file, std::string(64, '0')}, kImages);
    });
    EXPECT_THAT(tampered, AllOf(HasSubstr(image.file), HasSubstr(image.sha256)));
    const std::string resized = message_of(base::ExitCode::kBadInput, [&] {
        (void)load_stimulus(shown.folder, {image.file, image.sha256}, {320, 201});
    });
    EXPECT_THAT(resized, AllOf(HasSubstr(image.file), HasSubstr("320x200"), HasSubstr("320x201")));
    const std::string missing = message_of(base::ExitCode::kBadInput, [&] {
        (void)load_stimulus(shown.folder, {"missing.png", image.sha256}, kImages);
    });
    EXPECT_THAT(missing, HasSubstr("missing.png"));
}

TEST(KioskWindow, AnImageThatTheGpuCannotHoldIsAFailureThatNamesItsSize) {
    const VirtualDisplay display(640, 480);
    const Window window({0, false, {64, 64}});
    const std::string message = message_of(base::ExitCode::kFailed, [] {
        const StimulusTexture texture({{1 << 20, 1 << 20}, {}});
    });
    EXPECT_THAT(message, HasSubstr("1048576x1048576"));
}

TEST(KioskWindow, AMonitorSmallerThanTheImagesIsRefusedNamingBothSizes) {
    const VirtualDisplay display(640, 480);
    for (const bool windowed : {false, true}) {
        const std::string message = message_of(base::ExitCode::kBadInput, [&] {
            const Window window({0, windowed, {1280, 720}});
        });
        EXPECT_THAT(message, AllOf(HasSubstr("640x480"), HasSubstr("1280x720")));
    }
    const std::string message = message_of(base::ExitCode::kBadInput, [] {
        const Window window({4, false, {64, 64}});
    });
    EXPECT_THAT(message, AllOf(HasSubstr("--monitor: 4"), HasSubstr("640x480")));
}

TEST(KioskWindow, WithoutADisplayItSaysWhichVariablesItLookedAt) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const std::string message = message_of(base::ExitCode::kFailed, [] {
        const Window window({0, false, {64, 64}});
    });
    EXPECT_THAT(message, AllOf(HasSubstr("DISPLAY is not set"), HasSubstr("WAYLAND_DISPLAY")));
}

TEST(KioskWindow, TheFontsHaveTheLettersOfTheLanguagesOfEurope) {
    const VirtualDisplay display(1024, 768);
    Window window({0, true, {64, 64}});
    const stimuli::Words words;
    const Ui ui(window, words, 128);
    for (const ImWchar letter : {0x17D, 0x165, 0x3BB, 0x416, 0x2014, 0xE9}) {
        EXPECT_NE(ui.fonts().text->FindGlyphNoFallback(letter), nullptr) << letter;
        EXPECT_NE(ui.fonts().heading->FindGlyphNoFallback(letter), nullptr) << letter;
    }
}

TEST(Pace, IsLockedOnlyWhereFramesComeAtTheMonitorsRate) {
    const std::vector<double> steady(20, 1.0 / 60.0);
    EXPECT_TRUE(pace_of(steady, 60.0).locked);
    EXPECT_TRUE(pace_of(steady, 0.0).locked);
    EXPECT_DOUBLE_EQ(pace_of(steady, 60.0).lead_s(), 0.5 / 60.0);
    EXPECT_FALSE(pace_of(steady, 144.0).locked);
    EXPECT_DOUBLE_EQ(pace_of(steady, 144.0).lead_s(), 0.0);
    EXPECT_FALSE(pace_of(std::vector<double>(20, 0.002), 60.0).locked);
    std::vector<double> uneven = steady;
    for (std::size_t i = 0; i < uneven.size(); i += 3) uneven[i] *= 1.7;
    EXPECT_FALSE(pace_of(uneven, 60.0).locked);
    EXPECT_FALSE(pace_of({}, 60.0).locked);
}

TEST(Pace, CountsWholePeriodsBeyondTheFirstChance) {
    Pace pace;
    pace.period_s = 0.01;
    EXPECT_EQ(dropped_frames(pace, 1.0, 1.0), 0);
    EXPECT_EQ(dropped_frames(pace, 1.0, 1.0105), 0);
    EXPECT_EQ(dropped_frames(pace, 1.0, 1.0199), 1);
    EXPECT_EQ(dropped_frames(pace, 1.0, 1.0299), 2);
    EXPECT_EQ(dropped_frames(pace, 1.0, 0.995), 0);
}

TEST(KioskWindow, TheSelfTestMeasuresEachAlternationAndKeyAndSaysWhatItsTimesAre) {
    const ShownStudy shown(2, 2000);
    const VirtualDisplay display(1024, 768);
    KioskOptions options;
    options.windowed = true;
    const SelfTestRun run = run_self_test(shown.study, options, 8);
    EXPECT_EQ(run.error_ms.size(), 8U);
    EXPECT_EQ(run.test.error_ms, figures_of(run.error_ms));
    EXPECT_EQ(run.key_to_swap_ms.size(), 2U);
    for (const double error_ms : run.error_ms) EXPECT_GE(error_ms, -1e-6) << "never too early";
    for (const double latency_ms : run.key_to_swap_ms) EXPECT_GT(latency_ms, 0.0);
    EXPECT_FALSE(run.test.waits) << "an X server without a screen has no refresh";
    EXPECT_FALSE(run.test.holds());
    EXPECT_EQ(run.test.source, "glFinish after the swap");
    EXPECT_THAT(run.test.display, HasSubstr("window"));
}

TEST(KioskWindow, SideBySideEachImageIsItsFilesBytesAndTheFirstIsWhereReadingBegins) {
    const ShownStudy shown(2, 2000);
    const VirtualDisplay display(1024, 768);
    const Window window({0, false, room_beside(kImages)});
    const Extent size = window.size();
    const auto load = [&](std::size_t index) {
        const auto& entry = shown.manifest.images[index];
        return StimulusTexture(
            load_stimulus(shown.folder, StimulusImage{entry.file, entry.sha256}, kImages));
    };
    const StimulusTexture left = load(0);
    const StimulusTexture right = load(1);
    draw_beside(left, right, size, 128);
    const stimuli::RgbImage screen = read_back(size);
    const Extent room = room_beside(kImages);
    const auto pixels_of = [&](int from_x) {
        stimuli::RgbImage part{kImages.width, kImages.height, {}};
        const int from_y = size.height - (size.height - room.height) / 2 - room.height;
        for (int y = 0; y < kImages.height; ++y) {
            const auto at = static_cast<std::size_t>(((from_y + y) * size.width + from_x) * 3);
            part.rgb.insert(part.rgb.end(), screen.rgb.begin() + static_cast<long>(at),
                            screen.rgb.begin() + static_cast<long>(at) + kImages.width * 3);
        }
        return part;
    };
    const int from_x = (size.width - room.width) / 2;
    EXPECT_EQ(pixels_of(from_x).rgb, shown.images.at(shown.manifest.images[0].sha256).rgb);
    EXPECT_EQ(pixels_of(from_x + room.width - kImages.width).rgb,
              shown.images.at(shown.manifest.images[1].sha256).rgb);
    const auto tone_at = [&](int x) {
        return screen.rgb[static_cast<std::size_t>((size.height / 2 * size.width + x) * 3)];
    };
    EXPECT_EQ(tone_at(size.width / 2), 128) << "grey between them";
}

TEST(KioskWindow, TheIntervalIsGreyOrHasItsCrossOrItsMask) {
    ShownStudy shown(2, 2000);
    const VirtualDisplay display(1024, 768);
    const Window window({0, false, kImages});
    const Extent size = window.size();
    const auto screen_with = [&](stimuli::Interval interval) {
        shown.study.presentation.interval = interval;
        IntervalView(shown.study).draw(size);
        return read_back(size);
    };
    const auto others = [&](const stimuli::RgbImage& screen) {
        return wrong_pixels(screen, nullptr, size.width, size.height, 128);
    };
    EXPECT_EQ(others(screen_with(stimuli::Interval::kGrey)), 0);
    const stimuli::RgbImage cross = screen_with(stimuli::Interval::kFixation);
    EXPECT_EQ(others(cross), 2 * 10 * 2 - 4) << "two bars of 10 x 2 that share 2 x 2";
    const auto middle =
        static_cast<std::size_t>((size.height / 2 * size.width + size.width / 2) * 3);
    EXPECT_EQ(cross.rgb[middle], 0);
    const stimuli::RgbImage mask = screen_with(stimuli::Interval::kMask);
    const int area = kImages.width * kImages.height;
    EXPECT_GT(others(mask), area * 9 / 10);
    EXPECT_LE(others(mask), area) << "in the images' place alone";
    EXPECT_EQ(mask.rgb, screen_with(stimuli::Interval::kMask).rgb) << "the same each time";
}

}  // namespace
}  // namespace obscura::app::kiosk
