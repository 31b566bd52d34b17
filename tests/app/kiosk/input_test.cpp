// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/input.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace obscura::app::kiosk {
namespace {

constexpr int kA = 65;
constexpr int kTab = 258;
constexpr int kSpace = 32;
constexpr int kLeft = 0;
constexpr int kRight = 1;

/// All characters and keys that frames give until nothing is left.
std::u32string typed(Input& input) {
    std::u32string text;
    do {
        for (const Stroke& stroke : input.take_frame().strokes) {
            if (stroke.character != 0) text += stroke.character;
        }
    } while (input.more());
    return text;
}

void type(Input& input, int key, char32_t character, double time_s) {
    input.key_down({key, 0, time_s});
    input.types(character);
}

TEST(Input, APageSeesOnlyKeysThatWentDownSinceItTakesInput) {
    Input input;
    input.open_at(10.3);
    type(input, kA, U'a', 10.2);
    EXPECT_TRUE(input.take_frame().strokes.empty());
    type(input, kA, U'b', 10.4);
    EXPECT_EQ(typed(input), U"b");
}

TEST(Input, ACodeThatAScannerTypesWhileThePageOpensIsLeftOutWhole) {
    Input input;
    input.open_at(10.0);
    const std::u32string code = U"K7TEST";
    const auto scan = [&](double from_s) {
        for (std::size_t i = 0; i < code.size(); ++i) {
            type(input, kA, code[i], from_s + 0.02 * static_cast<double>(i));
        }
    };
    scan(9.95);
    EXPECT_EQ(typed(input), U"");
    scan(11.0);
    EXPECT_EQ(typed(input), code) << "scanned again it is there";
}

TEST(Input, TheRepeatsOfAKeyHeldOverFromThePageBeforeTypeNothing) {
    Input input;
    type(input, kA, U'a', 9.0);
    EXPECT_EQ(typed(input), U"a");
    input.forget();
    input.open_at(10.3);
    for (int i = 0; i < 5; ++i) {
        input.key_repeats(kA, 0);
        input.types(U'a');
    }
    EXPECT_EQ(typed(input), U"");
    type(input, kA, U'a', 11.0);
    input.key_repeats(kA, 0);
    input.types(U'a');
    EXPECT_EQ(typed(input), U"aa") << "pressed anew it types, and repeats";
}

TEST(Input, AButtonHeldOverCountsAsUpUntilItGoesDownAnew) {
    Input input;
    input.button_down(kLeft, 9.9);
    EXPECT_EQ(input.take_frame().buttons, std::vector<int>{kLeft});
    input.forget();
    input.open_at(10.3);
    EXPECT_TRUE(input.take_frame().buttons.empty());
    input.button_up(kLeft, 12.0);
    EXPECT_TRUE(input.take_frame().buttons.empty());
    input.button_down(kLeft, 12.1);
    EXPECT_EQ(input.take_frame().buttons, std::vector<int>{kLeft});
}

TEST(Input, TheSecondClickOfADoubleClickIsNotSeenByTheNextPage) {
    Input input;
    input.open_at(0.0);
    input.button_down(kLeft, 5.0);
    input.button_up(kLeft, 5.05);
    EXPECT_EQ(input.take_frame().buttons.size(), 1U);
    input.forget();  // the next page is shown at 5.06
    input.open_at(5.36);
    input.button_down(kLeft, 5.11);
    input.button_up(kLeft, 5.16);
    for (int frame = 0; frame < 50; ++frame) EXPECT_TRUE(input.take_frame().buttons.empty());
}

TEST(Input, AClickBetweenTwoFramesIsSeenInOne) {
    Input input;
    input.button_down(kRight, 1.0);
    input.button_up(kRight, 1.01);
    EXPECT_EQ(input.take_frame().buttons, std::vector<int>{kRight});
    EXPECT_TRUE(input.take_frame().buttons.empty());
    EXPECT_TRUE(input.take_clicks().empty()) << "only the left one is a click";
}

TEST(Input, AButtonIsSeenWhereThePointerWasWhenItWentDownAndWhenItCameUp) {
    Input input;
    input.pointer_moves({10.0, 20.0});
    input.button_down(kLeft, 1.0);
    input.button_up(kLeft, 1.01);
    input.pointer_moves({300.0, 20.0});
    input.button_down(kLeft, 1.02);
    input.pointer_moves({400.0, 20.0});
    for (const auto& [x, down] : {std::pair{10.0, true}, {10.0, false}, {300.0, true}}) {
        EXPECT_TRUE(input.more());
        const InputFrame frame = input.take_frame();
        EXPECT_EQ(frame.pointer, (PointerPlace{x, 20.0}));
        EXPECT_EQ(frame.buttons.size(), down ? 1U : 0U);
        ASSERT_EQ(frame.release.has_value(), !down);
        if (frame.release) {
            EXPECT_EQ(frame.release->pressed_s, 1.0);
            EXPECT_EQ(frame.release->released_s, 1.01);
        }
    }
    EXPECT_FALSE(input.more());
    EXPECT_EQ(input.take_frame().pointer, std::nullopt) << "it is where it is";
}

TEST(Input, WhatIsTypedBeforeAndAfterAClickKeepsItsSideOfIt) {
    Input input;
    type(input, kA, U'a', 1.0);
    input.button_down(kLeft, 1.1);
    type(input, kA, U'b', 1.2);
    const InputFrame before = input.take_frame();
    ASSERT_EQ(before.strokes.size(), 1U);
    EXPECT_TRUE(before.buttons.empty());
    const InputFrame click = input.take_frame();
    EXPECT_TRUE(click.strokes.empty());
    EXPECT_EQ(click.buttons, std::vector<int>{kLeft});
    EXPECT_EQ(typed(input), U"b");
}

TEST(Input, KeysThatCameTogetherKeepTheirOrderAndEachMayMoveTheFocus) {
    Input input;
    type(input, kA, U'3', 1.0);
    type(input, kA, U'0', 1.1);
    input.key_down({kTab, 0, 1.2});
    type(input, kSpace, U' ', 1.3);
    type(input, kA, U'x', 1.4);
    const InputFrame first = input.take_frame();
    ASSERT_EQ(first.strokes.size(), 2U);
    EXPECT_EQ(first.strokes[1].character, U'0');
    EXPECT_TRUE(input.more());
    const InputFrame second = input.take_frame();
    ASSERT_EQ(second.strokes.size(), 1U);
    EXPECT_EQ(second.strokes[0].key, kTab);
    const InputFrame third = input.take_frame();
    ASSERT_EQ(third.strokes.size(), 1U);
    EXPECT_EQ(third.strokes[0].key, kSpace);
    EXPECT_EQ(third.strokes[0].character, U' ');
    EXPECT_EQ(typed(input), U"x");
    EXPECT_FALSE(input.more());
}

TEST(Input, TextWithoutAKeyOfItsOwnIsTypedToo) {
    Input input;
    input.key_down({kA, 0, 1.0});
    input.types(U'\u5973');
    input.types(U'\u4EBA');
    EXPECT_EQ(typed(input), U"\u5973\u4EBA");
}

TEST(Input, WhoDecidesByTheTimeOfAPressGetsThemAllOnce) {
    Input input;
    input.open_at(100.0);
    input.key_down({kA, 3, 1.0});
    input.key_repeats(kA, 3);
    input.button_down(kLeft, 2.0);
    const auto keys = input.take_keys();
    ASSERT_EQ(keys.size(), 1U);
    EXPECT_EQ(keys[0].modifiers, 3);
    EXPECT_EQ(input.take_clicks(), std::vector<double>{2.0});
    EXPECT_TRUE(input.take_keys().empty());
    EXPECT_TRUE(input.take_clicks().empty());
    EXPECT_DOUBLE_EQ(input.last_press_s(), 2.0);
}

}  // namespace
}  // namespace obscura::app::kiosk
