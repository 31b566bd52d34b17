// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What people do with keyboard and mouse that was not meant for the page that comes next.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/app/kiosk/visitor.h"

namespace obscura::app::kiosk {
namespace {

using Colour = std::array<int, 3>;
constexpr Colour kShownAccent{37, 83, 128};   // of a page's way on
constexpr Colour kShownQuiet{190, 192, 194};  // of other buttons
constexpr Colour kShownField{244, 244, 245};  // of what is filled in

/// A row's stretch of one colour.
struct Band {
    int left;
    int right;
    int y;
    [[nodiscard]] int middle() const { return (left + right) / 2; }
};

bool is_colour(const stimuli::RgbImage& screen, int x, int y, const Colour& colour) {
    const auto* pixel = &screen.rgb[static_cast<std::size_t>((y * screen.width + x) * 3)];
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(pixel[i] - colour[i]) > 1) return false;
    }
    return true;
}

std::vector<Band> runs_of(const stimuli::RgbImage& screen, const Colour& colour, int at_least) {
    std::vector<Band> runs;
    for (int y = 0; y < screen.height; ++y) {
        for (int x = 0; x < screen.width; ++x) {
            const int left = x;
            while (x < screen.width && is_colour(screen, x, y, colour)) ++x;
            if (x - left >= at_least) runs.push_back({left, x - 1, y});
        }
    }
    return runs;
}

/// Clicks the first button of the colour, which the ring around the focus has as well but thinner.
void click_way_on(Visitor& visitor) {
    constexpr int kThicker = 8;
    const auto runs = runs_of(visitor.display().screen(), kShownAccent, 60);
    const auto button = std::find_if(runs.begin(), runs.end(), [&](const Band& top) {
        return std::any_of(runs.begin(), runs.end(), [&](const Band& below) {
            return below.y == top.y + kThicker && below.left <= top.middle() &&
                   top.middle() <= below.right;
        });
    });
    ASSERT_NE(button, runs.end()) << "there is no way on";
    visitor.click(button->middle(), button->y + kThicker);
}

TEST(KioskInput, ADoubleClickOnAnAnswerDoesNotBeginTheNextPair) {
    const ShownStudy shown(3, 100);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    visitor.look_at_pair();
    visitor.display().double_click(kScreenWidth / 2 - kScreenWidth / 8, kScreenHeight / 2 + 20);
    visitor.await_answers(1);
    for (int look = 0; look < 6; ++look) {
        ASSERT_TRUE(visitor.sees_page());
        pause(0.1);
    }
    EXPECT_EQ(visitor.store().trials().size(), 1U);
    visitor.leave();
}

TEST(KioskInput, AHeldKeyLeavesOnlyTheImageItWasPressedOn) {
    const ShownStudy shown(3, 100);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    (void)visitor.open_pair();
    visitor.settle();
    visitor.display().hold("space", 1.5);
    const std::string second = visitor.await_second_image();
    for (int look = 0; look < 4; ++look) {
        ASSERT_TRUE(visitor.sees(second));
        pause(0.1);
    }
    visitor.leave_second_image();
    visitor.answer("1", 1);
    visitor.leave();
}

TEST(KioskInput, AWholeSessionByMouseAlone) {
    const ShownStudy shown(2, 100, std::string(kSoon) + "pointer = true\nadvance = []\n");
    Visitor visitor(shown);
    visitor.start_program();
    click_way_on(visitor);
    std::vector<Band> fields;
    visitor.await("the form", [&] {
        fields = runs_of(visitor.display().screen(), kShownField, 10);
        return !fields.empty();
    });
    pause(0.4);
    // The digits 0 to 9 and the arrow back stand in one row; 4, 1, back, 2.
    const auto quiet = runs_of(visitor.display().screen(), kShownQuiet, 12);
    ASSERT_GE(quiet.size(), 11U);
    for (const std::size_t key : {4, 1, 10, 2}) {
        EXPECT_EQ(quiet[key].y, quiet[0].y);
        visitor.click(quiet[key].middle(), quiet[key].y + 6);
    }
    // The box of the consent is the lowest field.
    visitor.click(fields.back().middle(), fields.back().y - 4);
    pause(0.3);
    click_way_on(visitor);
    visitor.await("a session", [&] { return visitor.has_session(); });
    for (std::size_t pair = 0; pair < 2; ++pair) {
        // The instructions, once, and the page of the pairs.
        for (int page = 0; page < 10 && !visitor.seen_image(); ++page) {
            if (visitor.sees_page()) click_way_on(visitor);
            pause(0.5);
        }
        const std::string first = visitor.seen_image().value();
        visitor.settle();
        visitor.click(300, 300);
        visitor.await("the second image",
                      [&] { return visitor.seen_image().value_or(first) != first; });
        visitor.settle();
        visitor.click(kScreenWidth - 5, kScreenHeight - 5);
        visitor.await("the question", [&] { return visitor.sees_page(); });
        visitor.settle();
        visitor.click(kScreenWidth / 2 + kScreenWidth / 8, kScreenHeight / 2 + 20);
        visitor.await_answers(pair + 1);
    }
    Store store = visitor.store();
    EXPECT_EQ(store.participants().at(0).age_years, 42);
    EXPECT_EQ(store.sessions().at(0).state, analysis::SessionState::kCompleted);
    for (const auto& trial : store.trials()) EXPECT_FALSE(trial.response_first);
    visitor.leave();
}

}  // namespace
}  // namespace obscura::app::kiosk
