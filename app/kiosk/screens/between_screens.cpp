// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The pages between pairs.
#include <cmath>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

std::optional<Event> went_on() {
    if (primary_button(words()("continue"))) return WentOn{};
    return std::nullopt;
}

}  // namespace

std::optional<Event> feedback_screen(const Fonts& fonts, bool was_expected) {
    std::optional<Event> event;
    card(
        "##feedback", 30.0F,
        [&] {
            heading(fonts, words()("practice"));
            paragraph(words()(was_expected ? "feedback_expected" : "feedback_other"));
        },
        [&] { event = went_on(); });
    return event;
}

std::optional<Event> practice_over_screen(const Fonts& fonts, int count) {
    std::optional<Event> event;
    card(
        "##practice-over", 30.0F,
        [&] {
            heading(fonts, words()("practice_over"));
            paragraph(words()("practice_over_text", {{"count", std::to_string(count)}}));
        },
        [&] { event = went_on(); });
    return event;
}

std::optional<Event> break_screen(const Fonts& fonts, const Progress& at, double left_s) {
    std::optional<Event> event;
    const auto left = static_cast<int>(std::ceil(left_s));
    card(
        "##break", 30.0F,
        [&] {
            heading(fonts, words()("break"));
            paragraph(words()("break_text", {{"done", std::to_string(at.pair)},
                                             {"count", std::to_string(at.count)}}));
        },
        [&] {
            if (left > 0) {
                paragraph(words()("break_wait", {{"seconds", std::to_string(left)}}));
            } else {
                event = went_on();
            }
        });
    return event;
}

}  // namespace obscura::app::kiosk
