// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <thread>
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
inline constexpr double kPatience_s = 40.0;
/// A little more than a page or image takes nothing.
inline constexpr double kInputDelay_s = 0.4;

inline void pause(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// A participant and operator in front of the program.
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
        program_ = ChildProcess(command, -1, log().string());
        EXPECT_TRUE(wait_for([this] { return sees_page(); })) << said();
        pause(kInputDelay_s);
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
        EXPECT_EQ(exit_code(), 0) << said();
    }
    /// Of the program, when it has ended.
    [[nodiscard]] int exit_code() {
        int code = -1;
        EXPECT_TRUE(program_.wait(kPatience_s, code)) << said();
        return code;
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
        pause(kInputDelay_s);
        press("space");
        EXPECT_TRUE(wait_for([this] { return sees_grey(); }));
    }
    std::string await_second_image() {
        EXPECT_TRUE(wait_for([this] { return seen_image().has_value(); }));
        return seen_image().value_or("");
    }
    void leave_second_image() {
        pause(kInputDelay_s);
        press("space");
        EXPECT_TRUE(wait_for([this] { return sees_page(); }));
        pause(kInputDelay_s);
    }
    void await_answers(std::size_t count) {
        EXPECT_TRUE(wait_for([this, count] { return store().trials().size() == count; }));
        pause(kInputDelay_s);
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
    /// Whether the program comes to say that, within reason.
    [[nodiscard]] bool says(const std::string& text) const {
        return wait_for([&] { return said().find(text) != std::string::npos; });
    }
    /// Whether the store comes to hold that many events of that name.
    [[nodiscard]] bool notes(const std::string& event, int count = 1) const {
        return wait_for([&] {
            const auto events = store().events();
            return std::count_if(events.begin(), events.end(),
                                 [&](const auto& other) { return other.name == event; }) == count;
        });
    }
    static bool wait_for(const std::function<bool()>& condition, double seconds = kPatience_s) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            pause(0.03);
        }
        return true;
    }

  private:
    [[nodiscard]] std::filesystem::path log() const { return shown_.data / "log.txt"; }
    [[nodiscard]] bool is_on_screen(const stimuli::RgbImage* image) const {
        return wrong_pixels(display_.screen(), image, width(), height(), 128) == 0;
    }
    /// Of the program's window, which lies in the screen's upper left corner.
    [[nodiscard]] int width() const { return place_ == Place::kWindow ? 1024 : kScreenWidth; }
    [[nodiscard]] int height() const { return place_ == Place::kWindow ? 720 : kScreenHeight; }

    const ShownStudy& shown_;
    VirtualDisplay display_;
    Place place_;
    ChildProcess program_;
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
