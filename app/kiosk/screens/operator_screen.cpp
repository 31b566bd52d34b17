// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What the operator sees behind Ctrl+Shift+Q. Nothing on it says who took part.
#include <imgui.h>
// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

using Page = OperatorView::Page;

std::optional<OperatorAct> pin_page(const Fonts& fonts, OperatorView& view) {
    std::optional<OperatorAct> act;
    const auto wait = static_cast<int>(std::ceil(view.wait_s));
    const auto body = [&] {
        heading(fonts, words()("for_operator"));
        paragraph(words()("op_pin"));
        SideBySide row(ImGui::GetStyle().ItemSpacing.x);
        const float width = times_text(9.0F);
        row.next(width);
        text_field("##pin", view.pin, width);
        if (wait > 0) complaint(words()("op_pin_wrong", {{"seconds", std::to_string(wait)}}));
    };
    const auto foot = [&] {
        if (primary_button(words()("continue")) && wait <= 0) act = OperatorAct::kTryPin;
        if (quiet_button(words()("back")) || key_pressed(GLFW_KEY_ESCAPE)) act = OperatorAct::kStay;
    };
    card("##op-pin", 28.0F, body, foot);
    return act;
}

std::optional<OperatorAct> overview(const Fonts& fonts, const OperatorView& view) {
    std::optional<OperatorAct> act;
    const auto body = [&] {
        heading(fonts, words()("for_operator"));
        for (const std::string& line : view.lines) paragraph(line);
        if (!view.note.empty()) paragraph(view.note);
        gap(0.2F);
        paragraph(words()(view.session_open ? "leave_open" : "leave_closed"));
    };
    const auto foot = [&] {
        const float space = ImGui::GetFontSize();
        const float width = std::floor((ImGui::GetContentRegionAvail().x - space) * 0.5F);
        SideBySide row(space);
        const auto button = [&](const char* label, bool primary, OperatorAct does) {
            row.next(width);
            if (wide_button(words()(label), width, 2.1F, primary)) act = does;
        };
        button("op_back_up", false, OperatorAct::kBackUp);
        button("op_withdraw", false, OperatorAct::kChoose);
        button("leave", false, OperatorAct::kLeave);
        button("stay", true, OperatorAct::kStay);
        if (enter_pressed() || key_pressed(GLFW_KEY_ESCAPE)) act = OperatorAct::kStay;
        if (letter_pressed('b')) act = OperatorAct::kBackUp;
        if (letter_pressed('w')) act = OperatorAct::kChoose;
        if (letter_pressed('l')) act = OperatorAct::kLeave;
        gap(0.2F);
        paragraph(words()("op_keys"));
    };
    card("##operator", 40.0F, body, foot);
    return act;
}

std::optional<OperatorAct> sessions_page(const Fonts& fonts, OperatorView& view) {
    std::optional<OperatorAct> act;
    const auto body = [&] {
        heading(fonts, words()("op_withdraw"));
        paragraph(words()("op_withdraw_text"));
        if (view.sessions.empty()) paragraph(words()("op_none"));
        for (const std::string& session : view.sessions) {
            if (!wide_button(session, ImGui::GetContentRegionAvail().x, 1.6F, false)) continue;
            view.chosen = session;
            act = OperatorAct::kAsk;
        }
    };
    const auto foot = [&] {
        if (primary_button(words()("back")) || key_pressed(GLFW_KEY_ESCAPE)) {
            act = OperatorAct::kBack;
        }
    };
    card("##op-sessions", 36.0F, body, foot);
    return act;
}

std::optional<OperatorAct> sure_page(const Fonts& fonts, const OperatorView& view) {
    std::optional<OperatorAct> act;
    const auto body = [&] {
        heading(fonts, words()("op_withdraw"));
        paragraph(words()("op_sure", {{"session", view.chosen}}));
    };
    const auto foot = [&] {
        if (primary_button(words()("back")) || key_pressed(GLFW_KEY_ESCAPE)) {
            act = OperatorAct::kBack;
        }
        if (quiet_button(words()("op_erase"))) act = OperatorAct::kErase;
    };
    card("##op-sure", 34.0F, body, foot);
    return act;
}

}  // namespace

std::optional<OperatorAct> operator_screen(const Fonts& fonts, OperatorView& view) {
    switch (view.page) {
        case Page::kPin:
            return pin_page(fonts, view);
        case Page::kOverview:
            return overview(fonts, view);
        case Page::kSessions:
            return sessions_page(fonts, view);
        case Page::kSure:
            return sure_page(fonts, view);
    }
    return std::nullopt;
}

}  // namespace obscura::app::kiosk
