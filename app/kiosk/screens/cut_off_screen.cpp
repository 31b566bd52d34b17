// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

[[nodiscard]] std::string continue_label(const CutOffSession& session) {
    if (session.answered == session.count) return "Complete it: every pair is answered";
    return fmt::format("Continue at pair {}", session.answered + 1);
}

}  // namespace

std::optional<CutOffChoice> cut_off_screen(const Fonts& fonts, const CutOffSession& session) {
    std::optional<CutOffChoice> choice;
    const bool can_continue = session.refusal.empty();
    const auto body = [&] {
        paragraph("For the operator");
        heading(fonts, "The last run was cut off");
        paragraph(fmt::format("Session {} began at {} and has {} of {} answers.",
                              session.session_id, session.started_utc, session.answered,
                              session.count));
        if (!can_continue) complaint("It cannot be continued: " + session.refusal + ".");
    };
    const auto foot = [&] {
        if (can_continue && primary_button(continue_label(session).c_str())) {
            choice = CutOffChoice::kContinue;
        }
        if (quiet_button("Close it as abandoned")) choice = CutOffChoice::kAbandon;
        if (letter_pressed('a')) choice = CutOffChoice::kAbandon;
        gap(0.2F);
        paragraph(can_continue ? "Keys: Enter continues, A abandons." : "Key: A abandons.");
        paragraph(kOperatorsKey);
    };
    card("##cut-off", 34.0F, body, foot);
    return choice;
}

std::optional<bool> abandon_screen(const Fonts& fonts, const CutOffSession& session) {
    std::optional<bool> choice;
    const auto body = [&] {
        heading(fonts, "Close this session as abandoned?");
        paragraph(
            fmt::format("Its {} of {} answers stay in the store, but it can never be continued, "
                        "and no analysis counts it.",
                        session.answered, session.count));
    };
    const auto foot = [&] {
        if (primary_button("Back")) choice = false;
        if (quiet_button("Close it for good")) choice = true;
        if (letter_pressed('c')) choice = true;
        gap(0.2F);
        paragraph("Keys: Enter goes back, C closes it.");
    };
    card("##abandon", 34.0F, body, foot);
    return choice;
}

}  // namespace obscura::app::kiosk
