// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT

// The program itself in a real X server, driven by a keyboard and a mouse and looked at from
// outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "analysis/store/store.h"
#include "app/kiosk/pin.h"
#include "stimuli/order/order.h"
#include "tests/app/kiosk/visitor.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Kind;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(KioskProgram, ASessionByKeyboardAndMouseCommitsEveryAnswerOfWhatWasSeen) {
    constexpr double kGrey_ms = 800.0;
    const ShownStudy shown(7, 800, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    const std::vector<std::string> answers{"1", "2", "Left", "Right", "KP_1", "mouse", "mouse 2"};
    const std::vector<bool> first_chosen{true, false, true, false, true, true, false};
    std::vector<std::pair<std::string, std::string>> seen;
    for (std::size_t pair = 0; pair < 7; ++pair) {
        const std::string first = visitor.open_pair();
        if (pair == 0) {
            visitor.try_to_close();
            EXPECT_TRUE(visitor.sees(first)) << "nothing closes or changes an image";
        }
        visitor.settle();
        // The keys after the first come during the interval, which they cannot make shorter.
        visitor.display().keys({"space", "space", "Return"});
        seen.emplace_back(first, visitor.await_second_image());
        visitor.leave_second_image();
        if (answers[pair].starts_with("mouse")) {
            const int offset = kScreenWidth / (first_chosen[pair] ? -8 : 8);
            visitor.click(kScreenWidth / 2 + offset, kScreenHeight / 2 + 20);
            visitor.await_answers(pair + 1);
        } else {
            visitor.answer(answers[pair], pair + 1);
        }
    }
    visitor.leave();

    Store store = visitor.store();
    ASSERT_EQ(store.sessions().size(), 1U);
    const analysis::SessionRecord session = store.sessions()[0];
    EXPECT_EQ(session.state, analysis::SessionState::kCompleted);
    EXPECT_EQ(session.study_sha256, shown.study.sha256);
    EXPECT_THAT(session.timing, AllOf(HasSubstr("\"source\""), HasSubstr("\"waits\":false")));
    EXPECT_EQ(store.participants().at(0).age_years, 29);
    const auto order = stimuli::session_order(shown.study.order, 7, shown.study.seed, 0);
    const auto trials = store.trials();
    ASSERT_EQ(trials.size(), 7U);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const auto condition = static_cast<std::size_t>(order.conditions[i]);
        EXPECT_EQ(trials[i].condition, shown.study.conditions[condition].id);
        EXPECT_EQ(trials[i].first_sha256, seen[i].first);
        EXPECT_EQ(trials[i].second_sha256, seen[i].second);
        EXPECT_EQ(trials[i].response_first, first_chosen[i]) << "pair " << i;
        EXPECT_EQ(trials[i].kind, Kind::kParticipant);
        EXPECT_EQ(trials[i].override_reason, kOverride);
        EXPECT_GE(trials[i].grey_ms_measured, kGrey_ms);
        // However busy the machine is: what came late says by how many frames.
        constexpr double kFrame_ms = 1000.0 / 60.0;
        EXPECT_LE(trials[i].grey_ms_measured,
                  kGrey_ms + kFrame_ms * (1.2 + trials[i].dropped_frames));
        std::printf("grey interval: %.3f ms\n", trials[i].grey_ms_measured);
    }
}

TEST(KioskProgram, KilledAtAnyMomentItLosesNoAnswerAndTheSessionContinues) {
    const ShownStudy shown(3, 400, kSoon);
    Visitor visitor(shown, Visitor::Place::kWindow);
    visitor.start_program();
    visitor.sign_in();
    visitor.answer_pair("1", 1);
    const std::string first = visitor.open_pair();
    visitor.kill_program();
    EXPECT_EQ(visitor.store().trials().size(), 1U);

    visitor.start_program();
    visitor.turn("Return");  // the operator continues
    EXPECT_EQ(visitor.open_pair(), first) << "at the first unanswered pair";
    visitor.leave_first_image();
    visitor.kill_program();

    visitor.start_program();
    visitor.turn("Return");
    EXPECT_EQ(visitor.open_pair(), first);
    visitor.leave_first_image();
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    visitor.kill_program();
    EXPECT_EQ(visitor.store().trials().size(), 1U);

    visitor.start_program();
    visitor.turn("Return");
    visitor.answer_pair("2", 2);
    visitor.answer_pair("1", 3);
    visitor.leave();
    Store store = visitor.store();
    ASSERT_EQ(store.sessions().size(), 1U);
    EXPECT_EQ(store.sessions()[0].state, analysis::SessionState::kCompleted);
    const auto events = store.events();
    EXPECT_EQ(std::count_if(events.begin(), events.end(),
                            [](const auto& event) { return event.name == "session resumed"; }),
              3);
}

TEST(KioskProgram, ACutOffSessionCanBeClosedAsAbandonedAndGivesItsRowBack) {
    const ShownStudy shown(2, 100, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    visitor.answer_pair("1", 1);
    visitor.leave();  // in the middle of a session
    ASSERT_EQ(visitor.store().open_sessions("noise", Kind::kParticipant).size(), 1U);
    visitor.start_program();
    const std::filesystem::path log = shown.data / "second.txt";
    ChildProcess second(
        {OBSCURA_PROGRAM, "--data", shown.data.string(), "run", shown.file.string()}, -1,
        log.string());
    int code = -1;
    EXPECT_TRUE(second.wait(kPatience_s, code));
    EXPECT_EQ(code, 1) << "it would ask about this one's session";
    EXPECT_THAT(base::read_file(log), HasSubstr("another kiosk is running"));
    execute(shown,
            "CREATE TRIGGER no_room BEFORE UPDATE ON sessions "
            "BEGIN SELECT RAISE(ABORT, 'there is no room'); END");
    visitor.turn("a");
    visitor.press("a");
    visitor.turn("Return");  // asked once more, the operator goes back
    EXPECT_EQ(visitor.times_said("cannot close a session"), 0);
    visitor.turn("a");
    visitor.turn("c");
    visitor.await_words("cannot close a session");
    visitor.await_words("no room");
    EXPECT_TRUE(visitor.sees_page()) << "a store that fails does not end the program";
    execute(shown, "DROP TRIGGER no_room");
    visitor.turn("Return");  // tries again
    visitor.leave();
    EXPECT_EQ(visitor.store().sessions().at(0).state, analysis::SessionState::kAbandoned);
    EXPECT_TRUE(visitor.store().taken_slots("noise", shown.study.seed, Kind::kParticipant).empty());
}

TEST(KioskProgram, AnAnswerThatCannotBeSavedIsTriedAgainAndNotLost) {
    const ShownStudy shown(2, 100, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    visitor.answer_pair("1", 1);
    execute(shown,
            "CREATE TRIGGER no_room BEFORE INSERT ON trials "
            "BEGIN SELECT RAISE(ABORT, 'there is no room'); END");
    visitor.look_at_pair();
    visitor.turn("2");
    visitor.press_until("Return", "a second try",
                        [&] { return visitor.times_said("no room") > 1; });
    EXPECT_EQ(visitor.store().trials().size(), 1U);
    EXPECT_THAT(visitor.said(), AllOf(HasSubstr("the answer to pair 2"), HasSubstr("no room")));
    execute(shown, "DROP TRIGGER no_room");
    visitor.answer("Return", 2);
    EXPECT_FALSE(visitor.store().trials().at(1).response_first);
    visitor.leave();
    EXPECT_EQ(visitor.store().sessions().at(0).state, analysis::SessionState::kCompleted);
}

TEST(KioskProgram, TheOperatorsPageIsBehindItsPinAndWithdrawsWhoeverIsChosen) {
    const ShownStudy shown(2, 100, kSoon);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    visitor.answer_pair("1", 1);
    visitor.answer_pair("1", 2);
    visitor.turn("ctrl+shift+q");
    visitor.turn("w");
    visitor.press("space");
    visitor.settle();
    visitor.press("Escape");
    visitor.settle();
    EXPECT_EQ(visitor.store().trials().size(), 2U) << "whoever is at the kiosk is not erased";
    visitor.press("Escape");
    visitor.settle();
    visitor.turn("ctrl+shift+n");
    set_pin(pin_file(shown.data), "2718");
    visitor.turn("ctrl+shift+q");
    visitor.display().keys({"l", "w", "1", "1", "1", "1", "Return"});
    visitor.await_words("a wrong PIN was tried");
    visitor.settle();
    EXPECT_TRUE(visitor.runs());
    pause(1.0);  // before the next can be tried
    visitor.display().keys({"2", "7", "1", "8", "Return"});
    visitor.settle();
    visitor.turn("w");
    visitor.turn("space");  // the one session
    visitor.display().keys({"Tab", "space"});
    visitor.await("the answers to be gone", [&] { return visitor.store().trials().empty(); });
    visitor.settle();
    EXPECT_TRUE(visitor.store().participants().empty());
    visitor.press_until("b", "a backup", [&] {
        return std::filesystem::exists(shown.data / "backups") &&
               !std::filesystem::is_empty(shown.data / "backups");
    });
    std::filesystem::remove(pin_file(shown.data));
    visitor.press("Escape");
    visitor.settle();
    visitor.leave();
}

TEST(KioskProgram, RefusesBeforeAnyoneSitsDown) {
    const ShownStudy shown(2, 100, kSoon);
    const VirtualDisplay display(kScreenWidth, kScreenHeight);
    const auto exit_code_of_run = [&shown] {
        ChildProcess program(
            {OBSCURA_PROGRAM, "--data", shown.data.string(), "run", shown.file.string()}, -1,
            (shown.data / "log.txt").string());
        int code = -1;
        EXPECT_TRUE(program.wait(kPatience_s, code));
        return code;
    };
    const auto said = [&shown] { return base::read_file(shown.data / "log.txt"); };
    EXPECT_EQ(exit_code_of_run(), 1);
    EXPECT_THAT(said(), AllOf(HasSubstr("the refresh test failed"), HasSubstr("--override"),
                              Not(HasSubstr(" 0 Hz"))));
    std::filesystem::remove(shown.data / "responses.sqlite");
    const std::string file = shown.manifest.images[2].file;
    std::string bytes = base::read_file(shown.folder / file);
    base::write_file_atomically(shown.folder / file, bytes + "x");
    EXPECT_EQ(exit_code_of_run(), 2);
    EXPECT_THAT(said(), HasSubstr(file));
    std::filesystem::remove(shown.folder / file);
    EXPECT_EQ(exit_code_of_run(), 2);
    EXPECT_FALSE(std::filesystem::exists(shown.data / "responses.sqlite"));
    base::write_file_atomically(shown.folder / file, bytes);
    ::unsetenv("DISPLAY");
    EXPECT_EQ(exit_code_of_run(), 1);
    EXPECT_THAT(said(), HasSubstr("DISPLAY is not set"));
    EXPECT_FALSE(std::filesystem::exists(shown.data / "responses.sqlite"));
}

}  // namespace
}  // namespace obscura::app::kiosk
