// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/input.h"

#include <algorithm>
#include <utility>

namespace obscura::app::kiosk {
namespace {

constexpr int kLeftButton = 0;

[[nodiscard]] bool only_types(const Stroke& stroke) {
    return stroke.character != 0 && stroke.character != U' ';
}

}  // namespace

void Input::key_down(KeyPress press) {
    last_press_s_ = key_time_s_ = key_pressed_s_[press.key] = press.time_s;
    strokes_.push_back({{press.key, press.modifiers, false, 0}, press.time_s});
    key_may_type_ = true;
    keys_.push_back(std::move(press));
}

void Input::key_repeats(int key, int modifiers) {
    const auto pressed = key_pressed_s_.find(key);
    key_time_s_ = pressed != key_pressed_s_.end() ? pressed->second : kNever;
    strokes_.push_back({{key, modifiers, true, 0}, key_time_s_});
    key_may_type_ = true;
}

void Input::types(char32_t character) {
    if (key_may_type_ && !strokes_.empty()) {
        strokes_.back().stroke.character = character;
    } else {
        strokes_.push_back({{0, 0, false, character}, key_time_s_});
    }
    key_may_type_ = false;
}

void Input::button_down(int button, double time_s) {
    last_press_s_ = time_s;
    buttons_[button] = {time_s, true, true};
    if (button == kLeftButton) clicks_.push_back(time_s);
}

void Input::button_up(int button, double time_s) {
    last_release_s_ = time_s;
    buttons_[button].down = false;
}

void Input::forget() {
    strokes_.clear();
    keys_.clear();
    clicks_.clear();
    key_pressed_s_.clear();
    key_may_type_ = false;
    key_time_s_ = kNever;
    for (auto& [number, button] : buttons_) {
        button.pressed_s = kNever;
        button.tapped = false;
    }
}

InputFrame Input::take_frame() {
    InputFrame frame;
    std::size_t taken = 0;
    while (taken < strokes_.size()) {
        const TimedStroke& next = strokes_[taken];
        const bool acts = !only_types(next.stroke);
        if (acts && !frame.strokes.empty()) break;
        ++taken;
        if (next.pressed_s < open_from_s_) continue;
        frame.strokes.push_back(next.stroke);
        if (acts) break;
    }
    strokes_.erase(strokes_.begin(), strokes_.begin() + static_cast<std::ptrdiff_t>(taken));
    if (strokes_.empty()) key_may_type_ = false;
    for (auto& [number, button] : buttons_) {
        if ((button.down || button.tapped) && button.pressed_s >= open_from_s_) {
            frame.buttons.push_back(number);
        }
        button.tapped = false;
    }
    return frame;
}

std::vector<KeyPress> Input::take_keys() { return std::exchange(keys_, {}); }

std::vector<double> Input::take_clicks() { return std::exchange(clicks_, {}); }

}  // namespace obscura::app::kiosk
