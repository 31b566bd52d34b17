// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/key_names.h"

// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "app/window/letters.h"

namespace obscura::app::kiosk {

int key_named(const std::string& name) {
    static const std::map<std::string, int> kNamed{
        {"space", GLFW_KEY_SPACE},     {"enter", GLFW_KEY_ENTER},
        {"left", GLFW_KEY_LEFT},       {"right", GLFW_KEY_RIGHT},
        {"up", GLFW_KEY_UP},           {"down", GLFW_KEY_DOWN},
        {"page-up", GLFW_KEY_PAGE_UP}, {"page-down", GLFW_KEY_PAGE_DOWN}};
    if (const auto named = kNamed.find(name); named != kNamed.end()) return named->second;
    const char letter = name.at(0);
    return letter >= '0' && letter <= '9' ? GLFW_KEY_0 + (letter - '0')
                                          : window::key_of_letter(letter);
}

namespace {

/// The names of an answer's keys. On a mirrored page the first image's button is at the right.
[[nodiscard]] std::vector<std::string> keys_of(const AskedPage& page, int answer, bool mirrored) {
    if (page.question != nullptr && !page.question->keys.empty()) {
        return page.question->keys.at(static_cast<std::size_t>(answer));
    }
    if (page.question != nullptr && page.question->is_scale()) {
        const int step = page.question->min + answer;
        return {std::to_string(step == 10 ? 0 : step)};
    }
    if (answer == 2) return {"3", "down"};
    return {std::to_string(answer + 1), (answer == 0) != mirrored ? "left" : "right"};
}

}  // namespace

bool is_key(const KeyPress& press, const std::string& name) {
    const int key = key_named(name);
    const bool on_pad =
        (key == GLFW_KEY_ENTER && press.key == GLFW_KEY_KP_ENTER) ||
        (key >= GLFW_KEY_0 && key <= GLFW_KEY_9 && press.key == GLFW_KEY_KP_0 + (key - GLFW_KEY_0));
    return press.key == key || on_pad;
}

std::optional<int> answer_of(const KeyPress& press, const stimuli::Study& study,
                             const AskedPage& page) {
    for (int answer = 0; answer < page.answer_count(); ++answer) {
        const auto names = keys_of(page, answer, study.words.right_to_left());
        if (std::any_of(names.begin(), names.end(),
                        [&](const std::string& name) { return is_key(press, name); })) {
            return answer;
        }
    }
    return std::nullopt;
}

std::string shown_key(const AskedPage& page, int answer) {
    static const std::map<std::string, std::string> kArrows{
        {"left", "\u2190"}, {"right", "\u2192"}, {"up", "\u2191"}, {"down", "\u2193"}};
    for (const std::string& name : keys_of(page, answer, false)) {
        if (const auto arrow = kArrows.find(name); arrow != kArrows.end()) return arrow->second;
        if (name.size() == 1) {
            return {static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())))};
        }
    }
    return "";
}

}  // namespace obscura::app::kiosk
