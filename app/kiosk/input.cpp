// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/input.h"

#include <utility>

namespace obscura::app::kiosk {
namespace {

constexpr int kLeftButton = 0;
/// Characters nearer to each other come from a scanner, or belong to one word.
constexpr double kOneBurst_s = 0.1;

[[nodiscard]] bool only_types(const Stroke& stroke) {
    return stroke.character != 0 && stroke.character != U' ';
}

}  // namespace

void Input::key_down(KeyPress press) {
    last_press_s_ = key_time_s_ = key_pressed_s_[press.key] = press.time_s;
    waiting_.push_back(TimedStroke{{press.key, press.modifiers, false, 0}, press.time_s});
    key_may_type_ = true;
    keys_.push_back(std::move(press));
}

void Input::key_repeats(int key, int modifiers) {
    const auto pressed = key_pressed_s_.find(key);
    key_time_s_ = pressed != key_pressed_s_.end() ? pressed->second : kNever;
    waiting_.push_back(TimedStroke{{key, modifiers, true, 0}, key_time_s_});
    key_may_type_ = true;
}

void Input::types(char32_t character) {
    if (key_may_type_ && !waiting_.empty()) {
        std::get<TimedStroke>(waiting_.back()).stroke.character = character;
    } else {
        waiting_.push_back(TimedStroke{{0, 0, false, character}, key_time_s_});
    }
    key_may_type_ = false;
}

void Input::button_down(int button, double time_s) {
    last_press_s_ = time_s;
    waiting_.push_back(ButtonChange{button, true, time_s, pointer_});
    key_may_type_ = false;
    if (button == kLeftButton) clicks_.push_back(time_s);
}

void Input::button_up(int button, double time_s) {
    waiting_.push_back(ButtonChange{button, false, time_s, pointer_});
    key_may_type_ = false;
}

void Input::forget() {
    waiting_.clear();
    keys_.clear();
    clicks_.clear();
    key_pressed_s_.clear();
    buttons_.clear();
    key_may_type_ = false;
    key_time_s_ = kNever;
}

bool Input::hand_over(const ButtonChange& change, InputFrame& frame) {
    if (change.down) {
        if (change.time_s < open_from_s_) return false;
        buttons_[change.button] = change.time_s;
    } else {
        const auto held = buttons_.find(change.button);
        if (held == buttons_.end()) return false;
        frame.release = Release{held->second, change.time_s};
        buttons_.erase(held);
    }
    frame.pointer = change.place;
    return true;
}

bool Input::continues_left_out(const TimedStroke& next) const {
    return only_types(next.stroke) && !next.stroke.repeats &&
           next.pressed_s - left_out_s_ < kOneBurst_s;
}

InputFrame Input::take_frame() {
    InputFrame frame;
    while (!waiting_.empty()) {
        if (const auto* change = std::get_if<ButtonChange>(&waiting_.front())) {
            if (!frame.strokes.empty()) break;
            const bool seen = hand_over(*change, frame);
            waiting_.pop_front();
            if (seen) break;
            continue;
        }
        const TimedStroke next = std::get<TimedStroke>(waiting_.front());
        const bool acts = !only_types(next.stroke);
        if (acts && !frame.strokes.empty()) break;
        waiting_.pop_front();
        if (next.pressed_s < open_from_s_ || continues_left_out(next)) {
            if (next.stroke.character != 0) left_out_s_ = next.pressed_s;
            continue;
        }
        frame.strokes.push_back(next.stroke);
        if (acts) break;
    }
    if (waiting_.empty()) key_may_type_ = false;
    for (const auto& [number, pressed_s] : buttons_) frame.buttons.push_back(number);
    return frame;
}

std::vector<KeyPress> Input::take_keys() { return std::exchange(keys_, {}); }

std::vector<double> Input::take_clicks() { return std::exchange(clicks_, {}); }

}  // namespace obscura::app::kiosk
