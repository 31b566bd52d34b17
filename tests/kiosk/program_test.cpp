// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT

// The program itself in a real X server, driven by a keyboard and a mouse and looked at from
// outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <thread>

#include "analysis/store/store.h"
#include "renderer/base/files.h"
#include "stimuli/order/order.h"
#include "tests/kiosk/shown_study.h"
#include "tests/kiosk/virtual_display.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Kind;
using analysis::Store;
using testing::AllOf;
using testing::HasSubstr;

/// Larger than a plain window, so that the two differ.
constexpr int kScreenWidth = 1100;
constexpr int kScreenHeight = 800;
constexpr double kPatience_s = 40.0;

void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// A participant and operator in front of the program.
class Visitor {
  public:
    enum class Place { kWholeScreen, kWindow };

    explicit Visitor(const ShownStudy& shown, Place place = Place::kWholeScreen)
        : shown_(shown), display_(kScreenWidth, kScreenHeight), place_(place) {}

    void start_program() {
        std::vector<std::string> command{OBSCURA_PROGRAM, "--data", shown_.data.string(), "run",
                                         shown_.file.string()};
        if (place_ == Place::kWindow) command.emplace_back("--windowed");
        program_ = ChildProcess(command, -1, log().string());
        EXPECT_TRUE(wait_for([this] { return sees_page(); })) << said();
        pause(0.3);
    }
    void kill_program() {
        program_.kill(SIGKILL);
        int code = 0;
        EXPECT_TRUE(program_.wait(kPatience_s, code));
        EXPECT_EQ(code, 128 + SIGKILL);
    }
    void leave() {
        press("ctrl+shift+q");
        pause(0.7);
        press("l");
        int code = -1;
        EXPECT_TRUE(program_.wait(kPatience_s, code)) << said();
        EXPECT_EQ(code, 0) << said();
    }

    void press(const std::string& key) const { display_.key(key); }
    void click(int x, int y) const { display_.click(x, y); }

    /// Start page, form and instructions; ends on the page of pairs.
    void sign_in() {
        press("Return");
        pause(1.0);
        display_.type("29");
        for (const char* key : {"Down", "Down", "Down", "Down", "space"}) {
            pause(0.4);
            press(key);
        }
        pause(0.4);
        press("Return");
        EXPECT_TRUE(wait_for([this] { return has_session(); }));
        pause(0.5);
        press("Return");
        pause(0.5);
    }

    /// Presses the next pair's button until an image is there; gives the image's hash.
    std::string open_pair() {
        for (int attempt = 0; attempt < 10; ++attempt) {
            press("Return");
            if (wait_for([this] { return seen_image().has_value(); }, 2.0)) {
                return *seen_image();
            }
        }
        ADD_FAILURE() << "no image appears; " << said();
        return "";
    }
    void leave_first_image() {
        press("space");
        EXPECT_TRUE(wait_for([this] { return sees_grey(); }));
    }
    std::string await_second_image() {
        EXPECT_TRUE(wait_for([this] { return seen_image().has_value(); }));
        return seen_image().value_or("");
    }
    void leave_second_image() {
        pause(0.1);
        press("space");
        EXPECT_TRUE(wait_for([this] { return sees_page(); }));
        pause(0.3);
    }
    void await_answers(std::size_t count) {
        EXPECT_TRUE(wait_for([this, count] { return store().trials().size() == count; }));
        pause(0.3);
    }
    void answer_pair(const std::string& key, std::size_t answers_then) {
        (void)open_pair();
        leave_first_image();
        (void)await_second_image();
        leave_second_image();
        press(key);
        await_answers(answers_then);
    }

    [[nodiscard]] bool sees_grey() const { return is_on_screen(nullptr); }
    /// The hash of the image that fills its place exactly, grey all around.
    [[nodiscard]] std::optional<std::string> seen_image() const {
        const stimuli::RgbImage screen = display_.screen();
        for (const auto& [sha256, image] : shown_.images) {
            if (wrong_pixels(screen, &image, width(), height(), 128) == 0) return sha256;
        }
        return std::nullopt;
    }
    [[nodiscard]] bool sees_page() const {
        const stimuli::RgbImage screen = display_.screen();
        // A card covers the middle with its own even colour; before the window is there all is
        // black, and images are noise.
        const auto* middle =
            &screen.rgb[static_cast<std::size_t>((kScreenHeight / 2) * kScreenWidth * 3)];
        return middle[0] == 128 && !sees_grey() && !seen_image();
    }
    void try_to_close() const {
        press("Escape");
        press("alt+F4");
        display_.ask_windows_to_close();
        pause(0.2);
    }

    [[nodiscard]] Store store() const { return {shown_.store_url(), Store::Access::kReadOnly}; }
    [[nodiscard]] bool has_session() const {
        return std::filesystem::exists(shown_.data / "responses.sqlite") &&
               !store().sessions().empty();
    }
    [[nodiscard]] std::string said() const { return base::read_file(log()); }

  private:
    [[nodiscard]] std::filesystem::path log() const { return shown_.data / "log.txt"; }
    [[nodiscard]] bool is_on_screen(const stimuli::RgbImage* image) const {
        return wrong_pixels(display_.screen(), image, width(), height(), 128) == 0;
    }
    /// Of the program's window, which lies in the screen's upper left corner.
    [[nodiscard]] int width() const { return place_ == Place::kWindow ? 1024 : kScreenWidth; }
    [[nodiscard]] int height() const { return place_ == Place::kWindow ? 720 : kScreenHeight; }
    static bool wait_for(const std::function<bool()>& condition, double seconds = kPatience_s) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            pause(0.03);
        }
        return true;
    }

    const ShownStudy& shown_;
    VirtualDisplay display_;
    Place place_;
    ChildProcess program_;
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.at(values.size() / 2);
}

TEST(KioskProgram, ASessionByKeyboardAndMouseCommitsEveryAnswerOfWhatWasSeen) {
    const ShownStudy shown(7, 2000);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    const std::vector<std::string> answers{"1", "2", "Left", "Right", "KP_1", "mouse", "mouse 2"};
    const std::vector<bool> first_chosen{true, false, true, false, true, true, false};
    std::vector<std::pair<std::string, std::string>> seen;
    for (std::size_t pair = 0; pair < 7; ++pair) {
        const std::string first = visitor.open_pair();
        visitor.try_to_close();
        EXPECT_EQ(visitor.seen_image(), first) << "nothing closes or changes an image";
        visitor.leave_first_image();
        visitor.press("space");
        visitor.press("Return");
        EXPECT_TRUE(visitor.sees_grey()) << "the interval cannot be skipped";
        seen.emplace_back(first, visitor.await_second_image());
        visitor.leave_second_image();
        if (answers[pair].starts_with("mouse")) {
            const int offset = kScreenWidth / (first_chosen[pair] ? -8 : 8);
            visitor.click(kScreenWidth / 2 + offset, kScreenHeight / 2 + 20);
        } else {
            visitor.press(answers[pair]);
        }
        visitor.await_answers(pair + 1);
    }
    visitor.leave();

    Store store = visitor.store();
    ASSERT_EQ(store.sessions().size(), 1U);
    const analysis::SessionRecord session = store.sessions()[0];
    EXPECT_EQ(session.state, analysis::SessionState::kCompleted);
    EXPECT_EQ(session.study_sha256, shown.study.sha256);
    EXPECT_EQ(store.participants().at(0).age_years, 29);
    const auto order = stimuli::session_order(shown.study.order, 7, shown.study.seed, 0);
    const auto trials = store.trials();
    ASSERT_EQ(trials.size(), 7U);
    std::vector<double> grey_ms;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const auto condition = static_cast<std::size_t>(order.conditions[i]);
        EXPECT_EQ(trials[i].condition, shown.study.conditions[condition].id);
        EXPECT_EQ(trials[i].first_sha256, seen[i].first);
        EXPECT_EQ(trials[i].second_sha256, seen[i].second);
        EXPECT_EQ(trials[i].response_first, first_chosen[i]) << "pair " << i;
        EXPECT_EQ(trials[i].kind, Kind::kParticipant);
        EXPECT_GE(trials[i].grey_ms_measured, 2000.0);
        grey_ms.push_back(trials[i].grey_ms_measured);
    }
    constexpr double kFrame_ms = 1000.0 / 60.0;
    EXPECT_LE(median(grey_ms), 2000.0 + kFrame_ms);
    for (const double value : grey_ms) std::printf("grey interval: %.3f ms\n", value);
}

TEST(KioskProgram, KilledAtAnyMomentItLosesNoAnswerAndTheSessionContinues) {
    const ShownStudy shown(3, 400);
    Visitor visitor(shown, Visitor::Place::kWindow);
    visitor.start_program();
    visitor.sign_in();
    visitor.answer_pair("1", 1);
    const std::string first = visitor.open_pair();
    visitor.kill_program();
    EXPECT_EQ(visitor.store().trials().size(), 1U);

    visitor.start_program();
    visitor.press("Return");  // the operator continues
    pause(0.7);
    EXPECT_EQ(visitor.open_pair(), first) << "at the first unanswered pair";
    visitor.leave_first_image();
    visitor.kill_program();

    visitor.start_program();
    visitor.press("Return");
    pause(0.7);
    EXPECT_EQ(visitor.open_pair(), first);
    visitor.leave_first_image();
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    visitor.kill_program();
    EXPECT_EQ(visitor.store().trials().size(), 1U);

    visitor.start_program();
    visitor.press("Return");
    pause(0.7);
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

/// Runs SQL in the store beside the program.
void execute(const ShownStudy& shown, const char* sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((shown.data / "responses.sqlite").c_str(), &database), SQLITE_OK);
    sqlite3_busy_timeout(database, 5000);
    EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
}

TEST(KioskProgram, ACutOffSessionCanBeClosedAsAbandonedAndGivesItsRowBack) {
    const ShownStudy shown(2, 100);
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
    visitor.press("a");
    pause(1.0);
    EXPECT_THAT(visitor.said(), AllOf(HasSubstr("cannot close a session"), HasSubstr("no room")));
    EXPECT_TRUE(visitor.sees_page()) << "a store that fails does not end the program";
    execute(shown, "DROP TRIGGER no_room");
    visitor.press("Return");  // tries again
    pause(1.0);
    visitor.leave();
    EXPECT_EQ(visitor.store().sessions().at(0).state, analysis::SessionState::kAbandoned);
    EXPECT_TRUE(visitor.store().taken_slots("noise", shown.study.seed, Kind::kParticipant).empty());
}

TEST(KioskProgram, AnAnswerThatCannotBeSavedIsTriedAgainAndNotLost) {
    const ShownStudy shown(2, 100);
    Visitor visitor(shown);
    visitor.start_program();
    visitor.sign_in();
    visitor.answer_pair("1", 1);
    execute(shown,
            "CREATE TRIGGER no_room BEFORE INSERT ON trials "
            "BEGIN SELECT RAISE(ABORT, 'there is no room'); END");
    (void)visitor.open_pair();
    visitor.leave_first_image();
    (void)visitor.await_second_image();
    visitor.leave_second_image();
    visitor.press("2");
    pause(1.0);
    visitor.press("Return");  // tries again, in vain
    pause(1.0);
    EXPECT_EQ(visitor.store().trials().size(), 1U);
    EXPECT_THAT(visitor.said(), AllOf(HasSubstr("the answer to pair 2"), HasSubstr("no room")));
    execute(shown, "DROP TRIGGER no_room");
    visitor.press("Return");
    visitor.await_answers(2);
    EXPECT_FALSE(visitor.store().trials().at(1).response_first);
    visitor.leave();
    EXPECT_EQ(visitor.store().sessions().at(0).state, analysis::SessionState::kCompleted);
}

TEST(KioskProgram, RefusesBeforeAnyoneSitsDown) {
    const ShownStudy shown(2, 100);
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
