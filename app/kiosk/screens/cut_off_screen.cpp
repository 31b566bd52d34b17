// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <string>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

[[nodiscard]] std::string continue_label(const CutOffSession& session) {
    if (session.answered == session.count) return words()("complete_it");
    return words()("continue_at", {{"pair", std::to_string(session.answered + 1)}});
}

}  // namespace

std::optional<CutOffChoice> cut_off_screen(const Fonts& fonts, const CutOffSession& session) {
    std::optional<CutOffChoice> choice;
    const bool can_continue = session.refusal.empty();
    const auto body = [&] {
        paragraph(words()("for_operator"));
        heading(fonts, words()("cut_off"));
        paragraph(words()("cut_off_text", {{"session", session.session_id},
                                           {"time", session.started_utc},
                                           {"done", std::to_string(session.answered)},
                                           {"count", std::to_string(session.count)}}));
        if (!can_continue) complaint(words()("cannot_continue", {{"reason", session.refusal}}));
    };
    const auto foot = [&] {
        if (can_continue && primary_button(continue_label(session))) {
            choice = CutOffChoice::kContinue;
        }
        if (quiet_button(words()("abandon"))) choice = CutOffChoice::kAbandon;
        if (letter_pressed('a')) choice = CutOffChoice::kAbandon;
        gap(0.2F);
        paragraph(words()(can_continue ? "cut_off_keys" : "abandon_key"));
        paragraph(words()("operators_key"));
    };
    card("##cut-off", 34.0F, body, foot);
    return choice;
}

std::optional<bool> abandon_screen(const Fonts& fonts, const CutOffSession& session) {
    std::optional<bool> choice;
    const auto body = [&] {
        heading(fonts, words()("abandon_title"));
        paragraph(words()("abandon_text", {{"done", std::to_string(session.answered)},
                                           {"count", std::to_string(session.count)}}));
    };
    const auto foot = [&] {
        if (primary_button(words()("back"))) choice = false;
        if (quiet_button(words()("close_for_good"))) choice = true;
        if (letter_pressed('c')) choice = true;
        gap(0.2F);
        paragraph(words()("abandon_keys"));
    };
    card("##abandon", 34.0F, body, foot);
    return choice;
}

}  // namespace obscura::app::kiosk
