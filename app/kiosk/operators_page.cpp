// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/operators_page.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/kiosk/clock.h"
#include "app/kiosk/pin.h"
#include "renderer/base/log.h"

namespace obscura::app::kiosk {
namespace {

using Page = OperatorView::Page;

[[nodiscard]] std::vector<std::string> lines_of(const OperatorReport& report,
                                                const stimuli::Words& words) {
    const auto text = [](auto number) { return std::to_string(number); };
    std::vector<std::string> lines{words("op_sessions", {{"completed", text(report.completed)},
                                                         {"open", text(report.open)},
                                                         {"abandoned", text(report.abandoned)}}),
                                   words("op_next", {{"place", text(report.next.slot + 1)},
                                                     {"row", text(report.next.latin_row + 1)},
                                                     {"square", text(report.next.latin_square + 1)},
                                                     {"missing", text(report.to_balance)}})};
    if (report.checks + report.repeats > 0) {
        lines.push_back(words("op_checks", {{"right", text(report.checks_right)},
                                            {"checks", text(report.checks)},
                                            {"alike", text(report.repeats_alike)},
                                            {"repeats", text(report.repeats)}}));
    }
    return lines;
}

}  // namespace

void OperatorsPage::open(bool session_open, const std::string& session_on_screen) {
    session_on_screen_ = session_on_screen;
    view_ = OperatorView();
    view_.session_open = session_open;
    pressed_.reset();
    std::error_code ignored;
    if (std::filesystem::exists(hooks_.pin, ignored)) {
        view_.page = Page::kPin;
    } else {
        show_overview();
    }
}

std::optional<Event> OperatorsPage::draw() {
    view_.wait_s = std::max(0.0, next_pin_s_ - monotonic_s());
    const std::optional<OperatorAct> act = operator_screen(stage_.ui.fonts(), view_);
    if (act == OperatorAct::kLeave) return LeaveConfirmed{};
    if (act == OperatorAct::kStay) return LeaveCancelled{};
    if (act) pressed_ = act;
    return std::nullopt;
}

bool OperatorsPage::act() {
    covered_ = false;
    const std::optional<OperatorAct> act = std::exchange(pressed_, std::nullopt);
    if (act == OperatorAct::kTryPin) try_pin();
    if (act == OperatorAct::kBack) show_overview();
    if (act == OperatorAct::kChoose) choose();
    if (act == OperatorAct::kAsk) view_.page = Page::kSure;
    if (act == OperatorAct::kBackUp) note_of(hooks_.back_up);
    if (act == OperatorAct::kErase) {
        const auto chosen =
            std::find_if(report_.sessions.begin(), report_.sessions.end(),
                         [&](const auto& session) { return session.session_id == view_.chosen; });
        if (chosen != report_.sessions.end()) {
            note_of([&] { return hooks_.withdraw(*chosen); });
        }
        show_overview();
    }
    return covered_;
}

void OperatorsPage::try_pin() {
    if (monotonic_s() < next_pin_s_) return;
    bool right = false;
    try {
        right = is_pin(hooks_.pin, view_.pin.utf8());
    } catch (const std::exception& error) {
        base::log::error("{}", error.what());
    }
    view_.pin = OperatorView().pin;
    if (right) {
        wrong_pins_ = 0;
        show_overview();
        return;
    }
    next_pin_s_ = monotonic_s() + wait_after_wrong_s(++wrong_pins_);
    base::log::warn("a wrong PIN was tried, {} in a row", wrong_pins_);
}

void OperatorsPage::show_overview() {
    view_.page = Page::kOverview;
    const std::string note = view_.note;
    note_of([&] {
        report_ = hooks_.report();
        return note;
    });
    view_.lines = lines_of(report_, stage_.study.words);
    for (std::string& line : hooks_.machine_lines()) view_.lines.push_back(std::move(line));
}

/// An open session is closed at the kiosk's next start first, and the one on the screen left first.
void OperatorsPage::choose() {
    view_.page = Page::kSessions;
    view_.note.clear();
    view_.sessions.clear();
    for (const analysis::SessionRecord& session : report_.sessions) {
        if (session.state == analysis::SessionState::kOpen) continue;
        if (session.session_id == session_on_screen_) continue;
        view_.sessions.push_back(session.session_id);
    }
}

void OperatorsPage::note_of(const std::function<std::string()>& work) {
    try {
        bool page_shown = false;
        view_.note = done_aside(stage_, page_shown, work);
        covered_ = covered_ || page_shown;
    } catch (const std::exception& error) {
        base::log::error("{}", error.what());
        view_.note = error.what();
    }
}

}  // namespace obscura::app::kiosk
