// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/stage.h"

// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "app/kiosk/clock.h"
#include "app/window/letters.h"
#include "renderer/base/log.h"

namespace obscura::app::kiosk {
namespace {

/// A page follows input at once and for a few frames after it, then only a caret blinks.
constexpr int kLivelyFrames = 4;
constexpr double kLivelyWait_s = 1.0 / 60.0;
constexpr double kIdleWait_s = 0.2;
constexpr double kMillisecondsPerSecond = 1000.0;

/// Draws `page` until it gives a choice; nothing: the operator's key.
template <typename Choice>
[[nodiscard]] std::optional<Choice> ask(Stage& stage,
                                        const std::function<std::optional<Choice>()>& page) {
    draw_first_frame(stage.ui, [&] { (void)page(); });
    stage.window.present();
    stage.window.poll_events();
    Input& input = stage.window.input();
    const auto take_input = [&] {
        input.open_at(monotonic_s() +
                      stage.study.presentation.input_delay_ms / kMillisecondsPerSecond);
    };
    input.forget();
    take_input();
    bool end_seen = stage.ui.end_seen();
    std::optional<Choice> choice;
    int idle_frames = 0;
    while (!choice) {
        draw_next_frame(
            stage, [&] { choice = page(); }, idle_frames);
        if (!std::exchange(end_seen, stage.ui.end_seen()) && end_seen) {
            // What scrolled there presses nothing.
            choice.reset();
            take_input();
        }
        const auto keys = input.take_keys();
        if (!choice && std::any_of(keys.begin(), keys.end(),
                                   [](const auto& key) { return is_operators_key(key); })) {
            break;
        }
    }
    return choice;
}

}  // namespace

bool is_operators_key(const KeyPress& press, char letter) {
    constexpr int kBoth = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT;
    return (press.modifiers & kBoth) == kBoth && press.key == window::key_of_letter(letter);
}

void draw_first_frame(Ui& ui, const std::function<void()>& page) {
    ui.begin_page();
    for (int pass = 0; pass < kFirstFrames; ++pass) ui.draw(page);
}

void draw_next_frame(Stage& stage, const std::function<void()>& page, int& idle_frames) {
    const double wait_s = idle_frames < kLivelyFrames ? kLivelyWait_s : kIdleWait_s;
    const double before_s = monotonic_s();
    if (stage.window.input().more()) {
        stage.window.poll_events();
    } else {
        stage.window.wait_for_events(wait_s);
    }
    const bool input = monotonic_s() - before_s < 0.9 * wait_s || stage.window.take_damage();
    idle_frames = input ? 0 : idle_frames + 1;
    stage.ui.draw(page);
    stage.window.present();
}

TroubleChoice ask_about_trouble(Stage& stage, const Trouble& trouble) {
    const auto choice = ask<TroubleChoice>(stage, [&]() -> std::optional<TroubleChoice> {
        if (trouble_screen(stage.ui.fonts(), trouble)) return TroubleChoice::kRetry;
        return std::nullopt;
    });
    return choice.value_or(TroubleChoice::kLeave);
}

std::optional<CutOffChoice> ask_about_cut_off(Stage& stage, const CutOffSession& session) {
    return ask<CutOffChoice>(stage, [&] { return cut_off_screen(stage.ui.fonts(), session); });
}

std::optional<bool> ask_whether_to_abandon(Stage& stage, const CutOffSession& session) {
    return ask<bool>(stage, [&] { return abandon_screen(stage.ui.fonts(), session); });
}

bool wait_for_saving(Stage& stage, const std::function<bool(double)>& ready_within) {
    constexpr double kSoon_s = 0.5;
    if (ready_within(kSoon_s)) return false;
    base::log::warn("the store takes longer than half a second");
    const auto page = [&stage] { saving_screen(stage.ui.fonts()); };
    draw_first_frame(stage.ui, page);
    stage.window.present();
    int idle_frames = 0;
    while (!ready_within(0.0)) draw_next_frame(stage, page, idle_frames);
    stage.window.poll_events();
    stage.window.input().forget();
    return true;
}

}  // namespace obscura::app::kiosk
