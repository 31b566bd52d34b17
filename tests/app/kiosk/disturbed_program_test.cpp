// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT

// The program itself while something comes between it and the participant: other windows, other
// monitors, a store that is slow or full.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/kiosk/visitor.h"

namespace obscura::app::kiosk {
namespace {

using testing::HasSubstr;

TEST(KioskDisturbed, WhatHidesATrialIsAnEventAndItsColumnAndNothingIsAnsweredMeanwhile) {
    const ShownStudy shown(2, 300);
    Visitor visitor(shown);
    visitor.display().start_window_manager();
    visitor.start_program();
    visitor.sign_in();
    const std::string first = visitor.open_pair();
    visitor.display().tool({"xdotool", "search", "--name", "Obscura", "windowminimize"});
    EXPECT_TRUE(visitor.notes("iconified"));
    EXPECT_TRUE(visitor.notes("seen again")) << "the kiosk restores itself";
    EXPECT_TRUE(Visitor::wait_for([&] { return visitor.seen_image() == first; }));
    visitor.leave_first_image();
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    {
        const OtherWindow other(10, 10, 50, 50);
        EXPECT_TRUE(visitor.notes("covered"));
        visitor.press("1");
        pause(1.0);
        EXPECT_TRUE(visitor.store().trials().empty()) << "what is covered cannot be answered";
    }
    EXPECT_TRUE(visitor.notes("seen again", 2));
    pause(0.7);
    visitor.press("1");
    visitor.await_answers(1);
    EXPECT_GT(visitor.store().trials().at(0).hidden_ms.value(), 1000.0);

    visitor.answer_pair("2", 2);
    EXPECT_DOUBLE_EQ(visitor.store().trials().at(1).hidden_ms.value(), 0.0);
    visitor.leave();
}

TEST(KioskDisturbed, AMonitorThatGoesDuringAGreyIntervalEndsNoIntervalAndTheTrialGoesOnAfterwards) {
    const ShownStudy shown(2, 3000);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    (void)visitor.open_pair();
    visitor.leave_first_image();
    EXPECT_THROW(visitor.display().tool({"xrandr", "--output", "screen", "--off"}),
                 std::runtime_error);
    EXPECT_TRUE(visitor.notes("monitor lost")) << visitor.said();
    EXPECT_TRUE(Visitor::wait_for([&] { return visitor.sees_page(); })) << "a calm page";
    visitor.display().tool({"xrandr", "--output", "screen", "--mode",
                            fmt::format("{}x{}", kScreenWidth, kScreenHeight)});
    EXPECT_TRUE(visitor.notes("seen again"));
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    pause(0.5);
    visitor.press("2");
    visitor.await_answers(1);
    const auto trial = visitor.store().trials().at(0);
    EXPECT_GT(trial.hidden_ms.value(), 0.0);
    EXPECT_GE(trial.grey_ms_measured, 3000.0);
    visitor.leave();
}

TEST(KioskDisturbed, AnAnswerToALockedStoreIsSavedWhenTheLockGoesAndAPageSaysSoMeanwhile) {
    const ShownStudy shown(2, 100);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    (void)visitor.open_pair();
    visitor.leave_first_image();
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    pause(0.5);
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open((shown.data / "responses.sqlite").c_str(), &other), SQLITE_OK);
    sqlite3_busy_timeout(other, 5000);
    ASSERT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
    visitor.press("2");
    EXPECT_TRUE(visitor.says("longer than half a second"));
    EXPECT_TRUE(visitor.sees_page());
    sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    visitor.await_answers(1);
    visitor.answer_pair("1", 2);
    visitor.leave();
}

TEST(KioskDisturbed, LeavingWithAnAnswerThatCouldNotBeSavedExitsWithOne) {
    const ShownStudy shown(2, 100);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    execute(shown,
            "CREATE TRIGGER no_room BEFORE INSERT ON trials "
            "BEGIN SELECT RAISE(ABORT, 'there is no room'); END");
    (void)visitor.open_pair();
    visitor.leave_first_image();
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    pause(0.5);
    visitor.press("2");
    EXPECT_TRUE(visitor.says("no room"));
    pause(0.5);
    visitor.press("ctrl+shift+q");
    EXPECT_EQ(visitor.exit_code(), 1);
    EXPECT_THAT(visitor.said(), HasSubstr("not saved: the answer to pair 1"));
}

TEST(KioskDisturbed, AStoreThatIsMovedAwayIsNoticedBeforeTheNextPageAndUsedAgainWhenItIsBack) {
    const ShownStudy shown(2, 100);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    const auto store = shown.data / "responses.sqlite";
    std::filesystem::rename(store, shown.data / "elsewhere.sqlite");
    visitor.press("ctrl+shift+q");  // any next page
    EXPECT_TRUE(visitor.says("cannot save"));
    EXPECT_FALSE(std::filesystem::exists(store)) << "nothing makes another store in its place";
    std::filesystem::rename(shown.data / "elsewhere.sqlite", store);
    pause(0.7);
    visitor.press("Return");  // tries again
    pause(0.7);
    visitor.press("Return");  // the operator stays
    pause(0.7);
    visitor.answer_pair("1", 1);
    visitor.answer_pair("2", 2);
    visitor.leave();
}

TEST(KioskDisturbed, TheOperatorLeavesByTheLettersOfAFrenchKeyboard) {
    const ShownStudy shown(2, 100);
    Visitor visitor(shown);
    visitor.display().tool({"setxkbmap", "fr"});
    visitor.start_program();
    visitor.leave();
}

}  // namespace
}  // namespace obscura::app::kiosk
