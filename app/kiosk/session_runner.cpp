// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/session_runner.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "app/kiosk/clock.h"
#include "app/kiosk/key_names.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"

namespace obscura::app::kiosk {
namespace {

/// What comes by itself is drawn, unseen, this long before it is due; a page takes longer.
constexpr double kPrepare_s = 0.030;
constexpr double kPreparePage_s = 0.150;
constexpr double kImageWait_s = 0.5;

[[nodiscard]] bool is_still(Screen screen) {
    return screen == Screen::kFirstImage || screen == Screen::kInterval ||
           screen == Screen::kSecondImage || screen == Screen::kBothImages;
}

[[nodiscard]] bool advances(const KeyPress& press, const stimuli::Study& study) {
    return std::any_of(study.presentation.advance.begin(), study.presentation.advance.end(),
                       [&](const std::string& name) { return is_key(press, name); });
}

/// What a key means on that screen, beside what its page makes of it.
[[nodiscard]] std::optional<Event> meaning_of(const KeyPress& press, const Procedure& procedure,
                                              const stimuli::Study& study) {
    const Screen screen = procedure.screen();
    if (is_operators_key(press)) return LeaveRequested{};
    if (screen == Screen::kThanks && is_operators_key(press, 'n')) return NextParticipant{};
    if (screen == Screen::kKnownCode && is_operators_key(press, 'o')) return CodeConfirmed{};
    if (is_still(screen)) {
        if (advances(press, study)) return SpacePressed{};
        return std::nullopt;
    }
    if (screen != Screen::kQuestion) return std::nullopt;
    const std::optional<int> answer = answer_of(press, study, procedure.asked());
    return answer ? std::optional<Event>(AnswerPressed{*answer}) : std::nullopt;
}

[[nodiscard]] Trouble trouble_of(const Row& row, const std::string& reason,
                                 const stimuli::Words& words) {
    return {words("not_saved"), fmt::format("{}: {}", name_of(row), reason),
            words("not_saved_text")};
}

}  // namespace

SessionRunner::End SessionRunner::run() {
    asked_s_ = monotonic_s();
    while (true) {
        watch();
        if (!save()) return End::kLeft;
        if (procedure_.screen() == Screen::kDone) return End::kDone;
        if (procedure_.screen() == Screen::kLeft) return End::kLeft;
        if (procedure_.hidden() && procedure_.screen() != Screen::kConfirmLeave) {
            go_on_hidden();
            continue;
        }
        hidden_page_ = false;
        if (procedure_.request() != presented_) {
            show_first_frame();
            if (procedure_.screen() == Screen::kPairs && !load_pair()) return End::kLeft;
        } else {
            go_on();
        }
    }
}

bool SessionRunner::save() {
    const stimuli::Words& words = stage_.study.words;
    bool covered = false;
    while (const std::optional<std::string> reason = flush(covered)) {
        const bool nothing_waits = journal_.waiting().empty();
        base::log::error("cannot save {}: {}",
                         nothing_waits ? "what comes next" : describe(journal_.waiting().front()),
                         *reason);
        const Trouble trouble =
            nothing_waits ? Trouble{words("store_moved"), *reason, words("store_moved_text")}
                          : trouble_of(journal_.waiting().front(), *reason, words);
        if (ask_about_trouble(stage_, trouble) == TroubleChoice::kLeave) {
            for (const Row& row : journal_.waiting())
                base::log::error("not saved: {}", describe(row));
            return false;
        }
        covered = true;
    }
    if (covered) {
        // Another page stood over the screen, which is asked for only now.
        presented_ = 0;
        hidden_page_ = false;
        asked_s_ = monotonic_s();
    }
    return true;
}

std::optional<std::string> SessionRunner::flush(bool& covered) {
    if (journal_.waiting().empty()) {
        // A store that is gone is noticed before the next page, not in the middle of a pair.
        const bool in_a_pair =
            is_still(procedure_.screen()) && procedure_.screen() != Screen::kFirstImage;
        const bool page_due = procedure_.request() != presented_ && !in_a_pair;
        return page_due ? journal_.flush() : std::nullopt;
    }
    bool page_shown = false;
    auto reason = done_aside(stage_, page_shown, [this] { return journal_.flush(); });
    covered = covered || page_shown;
    return reason;
}

void SessionRunner::watch() {
    const Sight sight = stage_.window.sight();
    if (sight == Sight::kClear) {
        feed(ScreenSeen{}, moment_now());
    } else {
        feed(ScreenHidden{to_string(sight)}, moment_now());
    }
}

void SessionRunner::go_on_hidden() {
    constexpr double kRestore_s = 1.0;
    const Sight sight = stage_.window.sight();
    const std::string state = stage_.window.state();
    const auto page = [&] { hidden_screen(stage_.ui.fonts(), sight, state); };
    if (!hidden_page_) {
        draw_first_frame(stage_.ui, page);
        stage_.window.present();
        hidden_page_ = true;
        idle_frames_ = 0;
        base::log::warn("{}: {}", to_string(sight), state);
    } else {
        draw_next_frame(stage_, page, idle_frames_);
    }
    if (monotonic_s() - restored_s_ >= kRestore_s) {
        stage_.window.restore();
        restored_s_ = monotonic_s();
    }
    forward_presses();
}

bool SessionRunner::load_pair() {
    const int pair = procedure_.pair();
    const Extent extent{stage_.study.width, stage_.study.height};
    const auto load = [&](int position) {
        return std::make_unique<StimulusTexture>(
            load_stimulus(stage_.folder, procedure_.image(pair, position), extent));
    };
    while (!loaded_ || loaded_->pair != pair) {
        try {
            loaded_.reset();
            loaded_ = LoadedPair{pair, load(0), load(1)};
        } catch (const base::Error& error) {
            base::log::error("{}", error.what());
            const stimuli::Words& words = stage_.study.words;
            const Trouble trouble{words("no_image"), error.what(), words("no_image_text")};
            if (ask_about_trouble(stage_, trouble) == TroubleChoice::kLeave) return false;
            idle_frames_ = 0;
        }
    }
    return true;
}

void SessionRunner::show_first_frame() {
    if (procedure_.screen() == Screen::kConfirmLeave && opened_ != procedure_.request()) {
        opened_ = procedure_.request();
        operators_.open(procedure_.session_open(), procedure_.plan().session_id);
    }
    if (is_still(procedure_.screen())) {
        stage_.window.hide_pointer();
        draw_still(procedure_.screen());
    } else {
        draw_first_frame(stage_.ui, [this] { draw_page(procedure_.screen()); });
    }
    finish_presenting(asked_s_);
}

void SessionRunner::finish_presenting(double asked_s) {
    const double onset_s = stage_.window.present();
    // What was pressed before the screen was visible does not count.
    stage_.window.poll_events();
    stage_.window.input().forget();
    (void)stage_.window.take_damage();
    pressed_.reset();
    idle_frames_ = 0;
    presented_ = procedure_.request();
    const bool end_in_view = is_still(procedure_.screen()) || stage_.ui.end_seen();
    feed(ScreenPresented{dropped_frames(stage_.pace, asked_s, onset_s), end_in_view},
         moment_at(onset_s));
}

void SessionRunner::go_on() {
    if (procedure_.next_due_s()) {
        go_on_until_due();
    } else if (is_still(procedure_.screen())) {
        go_on_with_image();
    } else {
        go_on_with_page();
    }
}

void SessionRunner::go_on_with_page() {
    pressed_.reset();
    draw_next_frame(
        stage_, [this] { draw_page(procedure_.screen()); }, idle_frames_);
    forward_presses();
    // What covered the page is gone: it is shown anew.
    if (procedure_.screen() == Screen::kConfirmLeave && operators_.act()) presented_ = 0;
    if (pressed_) {
        // A button of the page is pressed when the mouse lets go of it.
        const auto& release = stage_.ui.input().release;
        feed(*pressed_, release
                            ? moment_of_press(release->released_s, release->pressed_s)
                            : moment_of_press(monotonic_s(), stage_.window.input().last_press_s()));
    }
    // Last, since it is stamped now and what was pressed before the frame a little earlier.
    if (stage_.ui.end_seen() && !procedure_.end_seen()) feed(EndSeen{}, moment_now());
}

void SessionRunner::go_on_with_image() {
    stage_.window.wait_for_events(kImageWait_s);
    forward_presses();
    mend_still();
}

void SessionRunner::mend_still() {
    if (procedure_.request() != presented_ || !stage_.window.take_damage()) return;
    draw_still(procedure_.screen());
    stage_.window.present();
}

void SessionRunner::go_on_until_due() {
    const double due_s = *procedure_.next_due_s();
    const Screen next = procedure_.next_in_pair();
    const double hand_over_s = due_s - stage_.pace.lead_s();
    const double left_s =
        hand_over_s - (is_still(next) ? kPrepare_s : kPreparePage_s) - monotonic_s();
    if (left_s > 0.0) {
        stage_.window.wait_for_events(left_s);
        forward_presses();
        mend_still();
        return;
    }
    if (is_still(next)) {
        draw_still(next);
    } else {
        draw_first_frame(stage_.ui, [&] { draw_page(next); });
    }
    glFinish();
    wait_until(hand_over_s);
    feed(Tick{std::max(due_s, monotonic_s() + stage_.pace.lead_s())}, moment_now());
    finish_presenting(due_s);
}

void SessionRunner::draw_still(Screen screen) {
    const Extent frame = stage_.window.size();
    const int grey = stage_.study.presentation.grey_level;
    stage_.window.light_patch(screen != Screen::kInterval);
    if (screen == Screen::kInterval) {
        interval_.draw(frame);
    } else if (screen == Screen::kBothImages) {
        const bool mirrored = stage_.study.words.right_to_left();
        draw_beside(mirrored ? *loaded_->second : *loaded_->first,
                    mirrored ? *loaded_->first : *loaded_->second, frame, grey);
    } else {
        (screen == Screen::kFirstImage ? loaded_->first : loaded_->second)->draw(frame, grey);
    }
}

void SessionRunner::draw_page(Screen screen) {
    stage_.window.light_patch(false);
    const Fonts& fonts = stage_.ui.fonts();
    const Progress at = procedure_.progress();
    std::optional<Event> pressed;
    switch (screen) {
        case Screen::kStart:
            pressed = start_screen(fonts);
            break;
        case Screen::kForm:
            pressed = form_screen(fonts, stage_.study, form_, procedure_.plan().known_codes);
            break;
        case Screen::kInformation:
            pressed = information_screen(fonts, stage_.study);
            break;
        case Screen::kConsent:
            pressed = consent_screen(fonts, *stage_.study.consent, form_);
            break;
        case Screen::kKnownCode:
            pressed = known_code_screen(fonts, procedure_.known_code());
            break;
        case Screen::kInstructions:
            pressed = instructions_screen(fonts, stage_.study);
            break;
        case Screen::kPairs:
            pressed = pairs_screen(fonts, at, stage_.study.has_next_button());
            break;
        case Screen::kQuestion:
            pressed = question_screen(fonts, stage_.study, at, procedure_.asked());
            break;
        case Screen::kFeedback:
            pressed = feedback_screen(fonts, procedure_.was_expected());
            break;
        case Screen::kPracticeOver:
            pressed = practice_over_screen(fonts, at.count);
            break;
        case Screen::kBreak:
            pressed =
                break_screen(fonts, at,
                             std::min<double>(stage_.study.presentation.break_min_s,
                                              procedure_.takes_presses_from_s() - monotonic_s()));
            break;
        case Screen::kThanks:
            thanks_screen(fonts, stage_.study, stage_.saved_note);
            break;
        case Screen::kConfirmLeave:
            pressed = operators_.draw();
            break;
        case Screen::kFirstImage:
        case Screen::kInterval:
        case Screen::kSecondImage:
        case Screen::kBothImages:
        case Screen::kDone:
        case Screen::kLeft:
            break;
    }
    if (pressed) pressed_ = std::move(pressed);
}

void SessionRunner::forward_presses() {
    watch();
    Input& input = stage_.window.input();
    for (const KeyPress& press : input.take_keys()) {
        if (const auto event = meaning_of(press, procedure_, stage_.study)) {
            feed(*event, moment_at(press.time_s));
        }
    }
    for (const double click_s : input.take_clicks()) {
        if (stage_.study.presentation.pointer && is_still(procedure_.screen())) {
            feed(SpacePressed{}, moment_at(click_s));
        }
    }
}

void SessionRunner::feed(const Event& event, const Moment& moment) {
    const int before = procedure_.request();
    journal_.add(procedure_.step(event, moment));
    if (procedure_.request() != before) asked_s_ = moment.time_s;
    stage_.window.input().open_at(procedure_.takes_presses_from_s());
}

}  // namespace obscura::app::kiosk
