// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The program itself at the hands of a monkey: random keys, clicks and window events, everything
// but the operator's own keys. OBSCURA_MONKEY_EVENTS makes it longer.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

#include "renderer/base/random.h"
#include "tests/app/kiosk/visitor.h"

namespace obscura::app::kiosk {
namespace {

constexpr int kUsualEvents = 400;
constexpr int kEventsAtOnce = 50;

int events_wanted() {
    const char* wanted = std::getenv("OBSCURA_MONKEY_EVENTS");
    return wanted != nullptr ? std::max(1, std::atoi(wanted)) : kUsualEvents;
}

/// What xdotool does in one go.
std::vector<std::string> some_events(base::Random& random) {
    static const std::vector<std::string> kKeys{
        "space",   "Return", "Tab",    "shift+Tab", "Escape",     "BackSpace", "Left",
        "Right",   "Up",     "Down",   "Page_Down", "Page_Up",    "Home",      "End",
        "1",       "2",      "3",      "a",         "l",          "n",         "o",
        "q",       "c",      "ctrl+q", "shift+q",   "ctrl+c",     "ctrl+w",    "alt+F4",
        "alt+Tab", "super",  "F1",     "F11",       "ctrl+alt+t", "Menu",      "KP_1"};
    std::vector<std::string> command{"xdotool"};
    for (int i = 0; i < kEventsAtOnce; ++i) {
        const auto what = random.below(10);
        if (what < 7) {
            // Those that lead on come often, so that it gets somewhere.
            const auto key = random.below(2) == 0 ? random.below(2) : random.below(kKeys.size());
            command.insert(command.end(), {"key", "--delay", "0", kKeys[key]});
        } else if (what < 9) {
            command.insert(command.end(), {"mousemove", std::to_string(random.below(kScreenWidth)),
                                           std::to_string(random.below(kScreenHeight))});
        } else {
            command.insert(command.end(), {"click", std::to_string(1 + random.below(5))});
        }
    }
    return command;
}

/// Whether every session that began is over, so that only the operator goes on.
bool all_are_over(const Visitor& visitor) {
    const auto sessions = visitor.store().sessions();
    return std::all_of(sessions.begin(), sessions.end(), [](const auto& session) {
        return session.state == analysis::SessionState::kCompleted;
    });
}

TEST(KioskMonkey, RandomInputNeitherLeavesTheKioskNorAnswersTwiceNorShortensTheGrey) {
    constexpr int kGrey_ms = 120;
    const ShownStudy shown(40, kGrey_ms, "input_delay_ms = 20\npairs_page = \"next\"\n");
    Visitor visitor(shown);
    // As the guide sets up a laboratory's machine: where the kiosk is iconified for a moment, a
    // click leads to no menu that ends the window manager.
    const std::string config = (shown.data / "openbox.xml").string();
    base::write_file_atomically(config,
                                "<openbox_config xmlns=\"http://openbox.org/3.4/rc\"><keyboard/>"
                                "<mouse/></openbox_config>\n");
    visitor.display().start_window_manager(config);
    visitor.start_program();
    visitor.sign_in();
    base::Random random(17);
    const int wanted = events_wanted();
    for (int sent = 0; sent < wanted; sent += kEventsAtOnce) {
        visitor.display().tool(some_events(random));
        if (random.below(8) == 0) {
            visitor.display().tool({"xdotool", "search", "--name", "Obscura", "windowminimize"});
        }
        if (random.below(8) == 0) visitor.display().ask_windows_to_close();
        ASSERT_TRUE(visitor.runs()) << visitor.said();
        if (all_are_over(visitor)) visitor.next_participant();
    }
    const auto trials = visitor.store().trials();
    std::map<std::string, std::set<std::string>> answered;
    double shortest_ms = 1e9;
    for (const auto& trial : trials) {
        auto& conditions = answered[trial.session_id];
        EXPECT_EQ(trial.trial_index, static_cast<int>(conditions.size()));
        EXPECT_TRUE(conditions.insert(trial.condition).second) << "answered twice";
        EXPECT_GE(trial.grey_ms_measured, kGrey_ms);
        shortest_ms = std::min(shortest_ms, trial.grey_ms_measured);
    }
    // It takes some 80 events to an answer.
    EXPECT_GT(trials.size(), static_cast<std::size_t>(wanted / 500)) << "it got stuck";
    std::printf("%d events, %zu sessions, %zu answers, shortest interval %.2f ms of %d\n", wanted,
                visitor.session_count(), trials.size(), shortest_ms, kGrey_ms);
    visitor.leave();
}

}  // namespace
}  // namespace obscura::app::kiosk
