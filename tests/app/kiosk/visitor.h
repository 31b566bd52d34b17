// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "analysis/store/store.h"
#include "renderer/base/files.h"
#include "tests/app/kiosk/shown_study.h"
#include "tests/app/kiosk/virtual_display.h"

namespace obscura::app::kiosk {

using analysis::Store;

/// Larger than a plain window, so that the two differ.
inline constexpr int kScreenWidth = 1100;
inline constexpr int kScreenHeight = 800;
/// How long anything may take before a test gives up. A machine may be busy.
inline constexpr double kPatience_s = 240.0;
/// A key that came too early, on a page that took nothing yet, is pressed again after that time.
inline constexpr double kAgain_s = 2.0;

/// For the tests that are not about how soon a page takes input.
inline constexpr const char* kSoon = "input_delay_ms = 100\n";

inline constexpr const char* kOverride = "a display for a test";

inline void pause(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// A participant and operator in front of the program. What they wait for in vain ends the test
/// with an exception that says what the program said: all that follows would wait in vain too.
class Visitor {
  public:
    enum class Place { kWholeScreen, kWindow };

    explicit Visitor(const ShownStudy& shown, Place place = Place::kWholeScreen)
        : shown_(shown), display_(kScreenWidth, kScreenHeight), place_(place) {}
    [[nodiscard]] VirtualDisplay& display() { return display_; }

    void start_program() {
        std::vector<std::string> command{OBSCURA_PROGRAM, "--data", shown_.data.string(), "run",
                                         shown_.file.string()};
        if (place_ == Place::kWindow) command.emplace_back("--windowed");
        // An X server without a screen has no refresh to wait for.
        command.insert(command.end(), {"--override", kOverride});
        program_ = ChildProcess(command, -1, log().string());
        await("the first page", [this] { return sees_page(); });
        settle();
    }
    void kill_program() {
        program_.kill(SIGKILL);
        EXPECT_EQ(exit_code(), 128 + SIGKILL);
    }
    void leave() {
        int code = -1;
        for (double waited_s = 0.0; waited_s < kPatience_s; waited_s += kAgain_s) {
            press("ctrl+shift+q");  // once more does nothing on the page that asks
            settle();
            press("l");
            if (!wait_for([&] { return program_.wait(0.0, code); }, kAgain_s)) continue;
            EXPECT_EQ(code, 0) << said();
            return;
        }
        give_up("the end of the program");
    }
    [[nodiscard]] bool runs() {
        int code = -1;
        return !program_.wait(0.0, code);
    }
    /// Of the program, when it has ended.
    [[nodiscard]] int exit_code() {
        int code = -1;
        await("the end of the program", [&] { return program_.wait(0.0, code); });
        return code;
    }

    void press(const std::string& key) const { display_.key(key); }
    void click(int x, int y) const { display_.click(x, y); }
    /// Until what is shown takes input.
    void settle() const { pause(shown_.study.presentation.input_delay_ms / 1000.0 + 0.1); }
    void press_until(const std::string& key, const std::string& what,
                     const std::function<bool()>& condition) const {
        for (double waited_s = 0.0; waited_s < kPatience_s; waited_s += kAgain_s) {
            press(key);
            if (wait_for(condition, kAgain_s)) return;
        }
        give_up(what);
    }
    /// Presses the key until another page is there, on a page without a caret.
    void turn(const std::string& key) const {
        const stimuli::RgbImage before = still_screen();
        press_until(key, "another page", [&] { return display_.screen().rgb != before.rgb; });
        settle();
    }

    /// Start page, form and instructions; ends on the page of pairs.
    void sign_in() {
        const std::size_t before = session_count();
        press_until("Return", "the form", [this] { return sees_form(); });
        settle();
        // The first keys may be lost. Continue takes the keyboard to what is still to be filled in.
        std::vector<std::string> keys(5, "BackSpace");
        for (const char* key : {"2", "9", "Return", "space", "Return"}) keys.emplace_back(key);
        const auto begun = [this, before] { return session_count() > before; };
        for (double waited_s = 0.0; !begun(); waited_s += kAgain_s) {
            if (waited_s >= kPatience_s) give_up("a session");
            display_.keys(keys);
            (void)wait_for(begun, kAgain_s);
        }
        settle();
        const auto read = static_cast<long>(before) + 1;
        press_until("Return", "the end of the instructions",
                    [this, read] { return count_events("instructions read") == read; });
        settle();
    }
    /// From the thanks to the page of pairs of the participant after.
    void next_participant() {
        for (double waited_s = 0.0; !sees_form(); waited_s += kAgain_s) {
            if (waited_s >= kPatience_s) give_up("the next participant's form");
            press("ctrl+shift+n");
            settle();
            press("Return");
            (void)wait_for([this] { return sees_form(); }, kAgain_s);
        }
        sign_in();
    }

    /// Presses the next pair's button until an image is there; gives the image's hash.
    std::string open_pair() {
        press_until("Return", "the first image", [this] { return sees_image(); });
        return image_;
    }
    void leave_first_image() {
        settle();
        press_until("space", "the grey interval", [this, first = image_] {
            return is_on(display_.screen(), nullptr) || seen_image().value_or(first) != first;
        });
    }
    std::string await_second_image() {
        await("the second image",
              [this, first = image_] { return sees_image() && image_ != first; });
        return image_;
    }
    void leave_second_image() {
        settle();
        press_until("space", "the question", [this] { return sees_page(); });
        settle();
    }
    /// Goes to the question of the next pair.
    void look_at_pair() {
        (void)open_pair();
        leave_first_image();
        (void)await_second_image();
        leave_second_image();
    }
    void await_answers(std::size_t count) {
        await("an answer", [this, count] { return store().trials().size() == count; });
        settle();
    }
    void answer(const std::string& key, std::size_t answers_then) {
        press_until(key, "an answer", [&] { return store().trials().size() == answers_then; });
        settle();
    }
    void answer_pair(const std::string& key, std::size_t answers_then) {
        look_at_pair();
        answer(key, answers_then);
    }

    /// Whether that image fills its place exactly, grey all around.
    [[nodiscard]] bool sees(const std::string& sha256) const {
        return is_on(display_.screen(), &shown_.images.at(sha256));
    }
    /// The hash of the image that is there.
    [[nodiscard]] std::optional<std::string> seen_image() const {
        const stimuli::RgbImage screen = display_.screen();
        for (const auto& [sha256, image] : shown_.images) {
            if (is_on(screen, &image)) return sha256;
        }
        return std::nullopt;
    }
    [[nodiscard]] bool sees_page() const {
        const stimuli::RgbImage screen = display_.screen();
        // A card covers the middle with its own even colour; before the window is there all is
        // black, and images are noise.
        const auto* middle =
            &screen.rgb[static_cast<std::size_t>((kScreenHeight / 2) * kScreenWidth * 3)];
        if (middle[0] != 128 || is_on(screen, nullptr)) return false;
        return std::none_of(shown_.images.begin(), shown_.images.end(),
                            [&](const auto& image) { return is_on(screen, &image.second); });
    }
    void try_to_close() const {
        press("Escape");
        press("alt+F4");
        display_.ask_windows_to_close();
        pause(0.2);
    }

    [[nodiscard]] Store store() const { return {shown_.store_url(), Store::Access::kReadOnly}; }
    [[nodiscard]] std::size_t session_count() const {
        if (!std::filesystem::exists(shown_.data / "responses.sqlite")) return 0;
        return store().sessions().size();
    }
    [[nodiscard]] bool has_session() const { return session_count() > 0; }
    [[nodiscard]] std::string said() const { return base::read_file(log()); }
    /// How often the program said that.
    [[nodiscard]] int times_said(const std::string& text) const {
        const std::string all = said();
        int count = 0;
        for (auto at = all.find(text); at != std::string::npos; at = all.find(text, at + 1))
            ++count;
        return count;
    }
    void await_words(const std::string& text) const {
        await("the words '" + text + "'", [&] { return times_said(text) > 0; });
    }
    /// Until the store holds that many events of that name.
    void await_event(const std::string& event, int count = 1) const {
        await(fmt::format("event '{}' {} times", event, count),
              [&] { return count_events(event) == count; });
    }
    void await(const std::string& what, const std::function<bool()>& condition) const {
        if (!wait_for(condition, kPatience_s)) give_up(what);
    }

  private:
    /// Of which nothing is being drawn.
    [[nodiscard]] stimuli::RgbImage still_screen() const {
        stimuli::RgbImage screen = display_.screen();
        await("a page at rest", [&] {
            pause(0.05);
            const stimuli::RgbImage before = std::exchange(screen, display_.screen());
            return before.rgb == screen.rgb;
        });
        return screen;
    }
    [[nodiscard]] long count_events(const std::string& name) const {
        const auto events = store().events();
        return std::count_if(events.begin(), events.end(),
                             [&](const auto& event) { return event.name == name; });
    }
    /// By the colour of what is filled in, which no other page has.
    [[nodiscard]] bool sees_form() const {
        const stimuli::RgbImage screen = display_.screen();
        int count = 0;
        for (std::size_t at = 0; at + 2 < screen.rgb.size(); at += 3) {
            if (screen.rgb[at] == 244 && screen.rgb[at + 1] == 244 && screen.rgb[at + 2] == 245) {
                ++count;
            }
        }
        return count > 1000;
    }
    [[noreturn]] void give_up(const std::string& what) const {
        throw std::runtime_error(
            fmt::format("waited in vain for {}; the program said:\n{}", what, said()));
    }
    static bool wait_for(const std::function<bool()>& condition, double seconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            pause(0.03);
        }
        return true;
    }
    [[nodiscard]] std::filesystem::path log() const { return shown_.data / "log.txt"; }
    [[nodiscard]] bool sees_image() {
        image_ = seen_image().value_or("");
        return !image_.empty();
    }
    [[nodiscard]] bool is_on(const stimuli::RgbImage& screen,
                             const stimuli::RgbImage* image) const {
        return shows(screen, image, width(), height(), 128);
    }
    /// Of the program's window, which lies in the screen's upper left corner.
    [[nodiscard]] int width() const { return place_ == Place::kWindow ? 1024 : kScreenWidth; }
    [[nodiscard]] int height() const { return place_ == Place::kWindow ? 720 : kScreenHeight; }

    const ShownStudy& shown_;
    VirtualDisplay display_;
    Place place_;
    ChildProcess program_;
    std::string image_;  ///< the hash of the last that was waited for
};

/// Runs SQL in the store beside the program.
inline void execute(const ShownStudy& shown, const char* sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((shown.data / "responses.sqlite").c_str(), &database), SQLITE_OK);
    sqlite3_busy_timeout(database, 5000);
    EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
}

}  // namespace obscura::app::kiosk
