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
    const ShownStudy shown(2, 300, kSoon);
    Visitor visitor(shown);
    visitor.display().start_window_manager();
    visitor.start_program();
    visitor.sign_in();
    const std::string first = visitor.open_pair();
    visitor.display().tool({"xdotool", "search", "--name", "Obscura", "windowminimize"});
    visitor.await_event("iconified");
    visitor.await_event("seen again");  // the kiosk restores itself
    visitor.await("the same image", [&] { return visitor.sees(first); });
    visitor.leave_first_image();
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    {
        const OtherWindow other(10, 10, 50, 50);
        visitor.await_event("covered");
        visitor.press("1");
        pause(0.5);
        EXPECT_TRUE(visitor.store().trials().empty()) << "what is covered cannot be answered";
    }
    visitor.await_event("seen again", 2);
    visitor.settle();
    visitor.answer("1", 1);
    EXPECT_GT(visitor.store().trials().at(0).hidden_ms.value(), 500.0);

    visitor.answer_pair("2", 2);
    EXPECT_DOUBLE_EQ(visitor.store().trials().at(1).hidden_ms.value(), 0.0);
    visitor.leave();
}

TEST(KioskDisturbed, AMonitorThatGoesDuringAGreyIntervalEndsNoIntervalAndTheTrialGoesOnAfterwards) {
    const ShownStudy shown(2, 1500, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    (void)visitor.open_pair();
    visitor.leave_first_image();
    EXPECT_THROW(visitor.display().tool({"xrandr", "--output", "screen", "--off"}),
                 std::runtime_error);
    visitor.await_event("monitor lost");
    visitor.await("a calm page", [&] { return visitor.sees_page(); });
    visitor.display().tool({"xrandr", "--output", "screen", "--mode",
                            fmt::format("{}x{}", kScreenWidth, kScreenHeight)});
    visitor.await_event("seen again");
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    visitor.answer("2", 1);
    const auto trial = visitor.store().trials().at(0);
    EXPECT_GT(trial.hidden_ms.value(), 0.0);
    EXPECT_GE(trial.grey_ms_measured, 1500.0);
    visitor.leave();
}

TEST(KioskDisturbed, AnAnswerToALockedStoreIsSavedWhenTheLockGoesAndAPageSaysSoMeanwhile) {
    const ShownStudy shown(2, 100, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    visitor.look_at_pair();
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open((shown.data / "responses.sqlite").c_str(), &other), SQLITE_OK);
    sqlite3_busy_timeout(other, 5000);
    ASSERT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
    visitor.press_until("2", "a slow store",
                        [&] { return visitor.times_said("longer than half a second") > 0; });
    EXPECT_TRUE(visitor.sees_page());
    sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    visitor.await_answers(1);
    visitor.answer_pair("1", 2);
    visitor.leave();
}

TEST(KioskDisturbed, LeavingWithAnAnswerThatCouldNotBeSavedExitsWithOne) {
    const ShownStudy shown(2, 100, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    execute(shown,
            "CREATE TRIGGER no_room BEFORE INSERT ON trials "
            "BEGIN SELECT RAISE(ABORT, 'there is no room'); END");
    visitor.look_at_pair();
    visitor.turn("2");
    visitor.await_words("no room");
    visitor.press("ctrl+shift+q");
    EXPECT_EQ(visitor.exit_code(), 1);
    EXPECT_THAT(visitor.said(), HasSubstr("not saved: the answer to pair 1"));
}

TEST(KioskDisturbed, AStoreThatIsMovedAwayIsNoticedBeforeTheNextPageAndUsedAgainWhenItIsBack) {
    const ShownStudy shown(2, 100, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    const auto store = shown.data / "responses.sqlite";
    std::filesystem::rename(store, shown.data / "elsewhere.sqlite");
    visitor.turn("ctrl+shift+q");  // any next page
    visitor.await_words("cannot save");
    EXPECT_FALSE(std::filesystem::exists(store)) << "nothing makes another store in its place";
    std::filesystem::rename(shown.data / "elsewhere.sqlite", store);
    visitor.turn("Return");  // tries again
    visitor.turn("Return");  // the operator stays
    const int complaints = visitor.times_said("cannot save");
    std::filesystem::rename(store, shown.data / "elsewhere.sqlite");
    visitor.press_until("Return", "a complaint instead of the first image",
                        [&] { return visitor.times_said("cannot save") > complaints; });
    visitor.settle();
    EXPECT_TRUE(visitor.sees_page());
    std::filesystem::rename(shown.data / "elsewhere.sqlite", store);
    visitor.answer_pair("1", 1);
    visitor.answer_pair("2", 2);
    visitor.leave();
}

TEST(KioskDisturbed, TheOperatorLeavesByTheLettersOfAFrenchKeyboard) {
    const ShownStudy shown(2, 100, kSoon);
    Visitor visitor(shown);
    visitor.display().tool({"setxkbmap", "fr"});
    visitor.start_program();
    visitor.leave();
}

}  // namespace
}  // namespace obscura::app::kiosk
