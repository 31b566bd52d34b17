// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/procedure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "renderer/base/error.h"

namespace obscura::app::kiosk {
namespace {

constexpr double kMillisecondsPerSecond = 1000.0;

template <typename T>
[[nodiscard]] bool is(const Event& event) {
    return std::holds_alternative<T>(event);
}

[[nodiscard]] bool is_image(Screen screen) {
    return screen == Screen::kFirstImage || screen == Screen::kSecondImage ||
           screen == Screen::kBothImages;
}

}  // namespace

FormProblems problems_of(const Form& form, const stimuli::Study& study) {
    FormProblems problems;
    problems.consent = !study.consent && !form.consent;
    if (study.form.empty()) {
        problems.age =
            !form.age_years || *form.age_years < kYoungest_years || *form.age_years > kOldest_years;
        return problems;
    }
    for (std::size_t i = 0; i < study.form.size(); ++i) {
        const FieldAnswer answer = i < form.fields.size() ? form.fields[i] : FieldAnswer{};
        if (problem_of(study.form[i], answer) != FieldProblem::kNone) problems.fields = true;
    }
    return problems;
}

Procedure::Procedure(const stimuli::Study& study, SessionPlan plan)
    : study_(&study), plan_(std::move(plan)), latest_s_(-std::numeric_limits<double>::infinity()) {
    for (std::size_t i = 0; i < plan_.questions.list.size(); ++i) {
        const bool each = plan_.questions.list[i].each_image;
        pages_.push_back({i, each ? 1 : 0});
        if (each) pages_.push_back({i, 2});
    }
}

void Procedure::change_order(stimuli::SessionOrder order) {
    assert(pair_ == 0 && order.conditions.size() == plan_.order.conditions.size());
    plan_.order = std::move(order);
}

const StimulusImage& Procedure::image(int pair, int position) const {
    const std::size_t side = (position == 0) == plan_.b_first(pair) ? 1 : 0;
    return plan_.images.at(plan_.condition_of(pair)).at(side);
}

Progress Procedure::progress() const {
    const int practice = plan_.practice_count();
    if (pair_ < practice) return {pair_, practice, true};
    return {pair_ - practice, pair_count() - practice, false};
}

std::optional<double> Procedure::next_due_s() const {
    if (!visible_) return std::nullopt;
    const stimuli::Presentation& shown = study_->presentation;
    if (screen_ == Screen::kInterval) {
        return trial_.interval_onset_s + shown.grey_ms / kMillisecondsPerSecond;
    }
    if (!is_image(screen_) || shown.exposure_ms == 0) return std::nullopt;
    return since_s_ - seen_before_s_ + shown.exposure_ms / kMillisecondsPerSecond;
}

Screen Procedure::next_in_pair() const {
    if (screen_ == Screen::kFirstImage) return Screen::kInterval;
    return screen_ == Screen::kInterval ? Screen::kSecondImage : Screen::kQuestion;
}

double Procedure::least_seen_s() const {
    const stimuli::Presentation& shown = study_->presentation;
    if (is_image(screen_)) return shown.min_view_ms / kMillisecondsPerSecond;
    if (screen_ == Screen::kQuestion) return shown.min_response_ms / kMillisecondsPerSecond;
    return screen_ == Screen::kBreak ? shown.break_min_s : 0.0;
}

void Procedure::show(Screen screen) {
    screen_ = screen;
    visible_ = false;
    end_seen_ = false;
    takes_presses_from_s_ = std::numeric_limits<double>::infinity();
    first_time_ = true;
    seen_before_s_ = 0.0;
    ++request_;
}

std::vector<Row> Procedure::step(const Event& event, const Moment& now) {
    if (screen_ == Screen::kDone || screen_ == Screen::kLeft) return {};
    if (!(now.time_s >= latest_s_)) return {};
    if (const auto* shown = std::get_if<ScreenPresented>(&event)) {
        if (!visible_ && (!hidden() || screen_ == Screen::kConfirmLeave)) {
            latest_s_ = now.time_s;
            presented(*shown, now.time_s);
        }
        return {};
    }
    if (const auto* gone = std::get_if<ScreenHidden>(&event)) return hide(gone->why, now);
    if (is<ScreenSeen>(event)) return see_again(now);
    if (!visible_ && !(hidden() && is<LeaveRequested>(event))) return {};
    latest_s_ = now.time_s;
    if (is<EndSeen>(event)) {
        end_came_into_view(now.time_s);
        return {};
    }
    if (!is<Tick>(event) && !is<LeaveRequested>(event) && !takes(now)) return {};
    if (screen_ == Screen::kConfirmLeave) {
        if (is<LeaveConfirmed>(event)) return decide_leave(true, now);
        if (is<LeaveCancelled>(event)) return decide_leave(false, now);
        return {};
    }
    if (is<LeaveRequested>(event)) return request_leave(now);
    return participant_did(event, now);
}

void Procedure::presented(const ScreenPresented& event, double time_s) {
    visible_ = true;
    since_s_ = time_s;
    takes_presses_from_s_ =
        time_s + std::max(study_->presentation.input_delay_ms / kMillisecondsPerSecond,
                          least_seen_s() - seen_before_s_);
    end_seen_ = event.end_in_view;
    // An interval that the operator's question interrupted starts anew; other screens keep their
    // onset.
    if (screen_ == Screen::kInterval) trial_.interval_onset_s = time_s;
    if (first_time_) note_onset(time_s);
    if (screen_ != Screen::kConfirmLeave) {
        if (gone_since_s_) trial_.hidden_s += time_s - *gone_since_s_;
        gone_since_s_.reset();
        first_time_ = false;
        trial_.dropped_frames += event.dropped_frames;
    }
}

void Procedure::note_onset(double time_s) {
    const bool both = screen_ == Screen::kBothImages;
    if (screen_ == Screen::kFirstImage || both) trial_.first_onset_s = time_s;
    if (screen_ == Screen::kSecondImage || both) trial_.second_onset_s = time_s;
    if (screen_ == Screen::kQuestion && page_ == 0) trial_.question_onset_s = time_s;
    // An image that went by itself was seen until this.
    if (!went_by_itself_s_) return;
    const bool second = screen_ == Screen::kQuestion;
    (second ? trial_.second_view_s : trial_.first_view_s) = time_s - *went_by_itself_s_;
    if (second && study_->presentation.layout == stimuli::Layout::kSideBySide) {
        trial_.first_view_s = trial_.second_view_s;
    }
    went_by_itself_s_.reset();
}

/// What made the page scroll to its end does not leave it as well.
void Procedure::end_came_into_view(double time_s) {
    if (end_seen_) return;
    end_seen_ = true;
    takes_presses_from_s_ =
        std::max(takes_presses_from_s_,
                 time_s + study_->presentation.input_delay_ms / kMillisecondsPerSecond);
}

bool Procedure::takes(const Moment& pressed) const {
    return end_seen_ && pressed.pressed_s >= takes_presses_from_s_;
}

std::vector<Row> Procedure::participant_did(const Event& event, const Moment& now) {
    switch (screen_) {
        case Screen::kStart:
            if (is<StartPressed>(event)) show(after(Screen::kStart));
            break;
        case Screen::kInformation:
            if (is<InformationRead>(event)) show(after(Screen::kInformation));
            break;
        case Screen::kConsent:
            if (is<ConsentGiven>(event)) {
                consent_utc_ = now.utc;
                show(after(Screen::kConsent));
            }
            break;
        case Screen::kForm:
            if (const auto* submitted = std::get_if<FormSubmitted>(&event)) {
                return submit(submitted->form, now);
            }
            break;
        case Screen::kKnownCode:
            if (is<CodeTakenBack>(event)) show(Screen::kForm);
            if (is<CodeConfirmed>(event)) return begin(submitted_, now);
            break;
        case Screen::kInstructions:
            if (is<InstructionsRead>(event)) {
                show(Screen::kPairs);
                return {event_record(kInstructionsReadEvent, "", now)};
            }
            break;
        case Screen::kPairs:
            if (const auto* pressed = std::get_if<PairPressed>(&event)) {
                if (pressed->pair == progress().pair) begin_pair();
            }
            break;
        case Screen::kFirstImage:
        case Screen::kSecondImage:
        case Screen::kBothImages:
        case Screen::kInterval:
            if (const auto* tick = std::get_if<Tick>(&event)) time_passed(tick->expected_onset_s);
            if (is<SpacePressed>(event) && is_image(screen_) && !next_due_s()) {
                leave_image(seen_s(now.time_s));
            }
            break;
        case Screen::kQuestion:
            if (const auto* answered = std::get_if<Answered>(&event)) {
                return answer(answered->first ? 0 : 1, now);
            }
            if (const auto* pressed = std::get_if<AnswerPressed>(&event)) {
                return answer(pressed->answer, now);
            }
            break;
        case Screen::kFeedback:
        case Screen::kPracticeOver:
            if (is<WentOn>(event)) {
                show(screen_ == Screen::kFeedback ? after_pair() : Screen::kPairs);
            }
            break;
        case Screen::kBreak:
            if (is<WentOn>(event)) return end_break(now);
            break;
        case Screen::kThanks:
            if (is<NextParticipant>(event)) show(Screen::kDone);
            break;
        case Screen::kConfirmLeave:
        case Screen::kDone:
        case Screen::kLeft:
            break;
    }
    return {};
}

/// The page that comes next of those before the form, which a study may have or not.
Screen Procedure::after(Screen screen) const {
    if (screen == Screen::kStart && !study_->information.empty()) return Screen::kInformation;
    if (screen != Screen::kConsent && study_->consent) return Screen::kConsent;
    return Screen::kForm;
}

std::vector<Row> Procedure::submit(const Form& form, const Moment& now) {
    if (!problems_of(form, *study_).none()) return {};
    const std::string code = code_in(study_->form, form.fields);
    const bool is_known = std::any_of(plan_.known_codes.begin(), plan_.known_codes.end(),
                                      [&](const auto& other) { return is_same_code(code, other); });
    if (code.empty() || !is_known) return begin(form, now);
    submitted_ = form;
    show(Screen::kKnownCode);
    return {};
}

std::vector<Row> Procedure::begin(const Form& form, const Moment& now) {
    const bool code_was_known = screen_ == Screen::kKnownCode;
    began_ = true;
    began_s_ = now.time_s;
    BeginSession rows;
    rows.participant = participant_record(form, now);
    rows.session = session_record(now);
    rows.events = {event_record(kStimuliEvent, digest_of(plan_.images), now)};
    if (code_was_known) {
        rows.events.push_back(event_record("code known", "the operator went on with it", now));
    }
    show(Screen::kInstructions);
    return {std::move(rows)};
}

void Procedure::begin_pair() {
    trial_ = {};
    page_ = 0;
    chose_first_.reset();
    const bool beside = study_->presentation.layout == stimuli::Layout::kSideBySide;
    show(beside ? Screen::kBothImages : Screen::kFirstImage);
}

void Procedure::leave_image(double seen_s) {
    if (screen_ != Screen::kSecondImage) trial_.first_view_s = seen_s;
    if (screen_ != Screen::kFirstImage) trial_.second_view_s = seen_s;
    show(next_in_pair());
}

void Procedure::time_passed(double expected_onset_s) {
    const std::optional<double> due_s = next_due_s();
    if (!due_s || expected_onset_s < *due_s) return;
    if (screen_ == Screen::kInterval) {
        show(Screen::kSecondImage);
        return;
    }
    const double seen_from_s = since_s_ - seen_before_s_;
    leave_image(expected_onset_s - seen_from_s);
    went_by_itself_s_ = seen_from_s;
}

Screen Procedure::after_pair() const {
    if (pair_ == pair_count()) return Screen::kThanks;
    const int answered = pair_ - plan_.practice_count();
    if (answered < 0) return Screen::kPairs;
    if (answered == 0) return Screen::kPracticeOver;
    const int between = study_->presentation.break_after;
    return between > 0 && answered % between == 0 ? Screen::kBreak : Screen::kPairs;
}

std::vector<Row> Procedure::end_break(const Moment& now) {
    const std::string detail =
        fmt::format("{:.1f} s, after {} pairs", seen_s(now.time_s), progress().pair);
    show(Screen::kPairs);
    return {event_record("break", detail, now)};
}

void Procedure::go_out_of_sight(double time_s) {
    seen_before_s_ = seen_s(time_s);
    visible_ = false;
    takes_presses_from_s_ = std::numeric_limits<double>::infinity();
    went_by_itself_s_.reset();
    if (!gone_since_s_) gone_since_s_ = time_s;
}

std::vector<Row> Procedure::hide(const std::string& why, const Moment& now) {
    if (hidden_why_ == why) return {};
    latest_s_ = now.time_s;
    if (!hidden()) {
        hidden_since_s_ = now.time_s;
        if (screen_ != Screen::kConfirmLeave) go_out_of_sight(now.time_s);
    }
    hidden_why_ = why;
    if (!session_open()) return {};
    return {event_record(why, place(), now)};
}

std::vector<Row> Procedure::see_again(const Moment& now) {
    if (!hidden()) return {};
    latest_s_ = now.time_s;
    hidden_why_.clear();
    if (screen_ != Screen::kConfirmLeave) ++request_;
    if (!session_open()) return {};
    const double gone_ms = (now.time_s - hidden_since_s_) * kMillisecondsPerSecond;
    return {event_record("seen again", fmt::format("after {:.0f} ms, {}", gone_ms, place()), now)};
}

std::vector<Row> Procedure::request_leave(const Moment& now) {
    go_out_of_sight(now.time_s);
    const double seen_before_s = seen_before_s_;
    covered_ = screen_;
    covered_first_time_ = first_time_;
    show(Screen::kConfirmLeave);
    seen_before_s_ = seen_before_s;
    return {event_record("operator asked to leave", "", now)};
}

std::vector<Row> Procedure::decide_leave(bool leave, const Moment& now) {
    const double seen_before_s = seen_before_s_;
    show(leave ? Screen::kLeft : covered_);
    seen_before_s_ = seen_before_s;
    first_time_ = covered_first_time_;
    return {event_record(leave ? "operator left" : "operator stayed", "", now)};
}

std::vector<Row> Procedure::resume(const std::vector<analysis::TrialRecord>& answered,
                                   bool instructions_read, double elapsed_s, const Moment& now,
                                   const std::vector<analysis::EventRecord>& events) {
    if (static_cast<int>(answered.size()) > pair_count()) {
        throw base::bad_input("session {} has {} answers, the study has {} pairs", plan_.session_id,
                              answered.size(), pair_count());
    }
    for (std::size_t i = 0; i < answered.size(); ++i) {
        const std::string& expected =
            study_->conditions.at(plan_.condition_of(static_cast<int>(i))).id;
        if (answered[i].trial_index != static_cast<int>(i) || answered[i].condition != expected) {
            throw base::bad_input(
                "session {} cannot be continued: its answer {} is of condition {} at place {}, the "
                "order has condition {} there",
                plan_.session_id, i + 1, answered[i].condition, answered[i].trial_index + 1,
                expected);
        }
    }
    began_ = true;
    began_s_ = now.time_s - elapsed_s;
    latest_s_ = now.time_s;
    pair_ = static_cast<int>(answered.size());
    const auto open = pair_ > 0 ? open_page(pair_ - 1, events) : std::nullopt;
    if (open) --pair_;
    const std::string detail = fmt::format(
        "at pair {} of {}, on {}; {}; {}", std::min(pair_ + 1, pair_count()), pair_count(),
        plan_.machine.software, plan_.machine.gpu_renderer, plan_.machine.display);
    std::vector<Row> rows{event_record("session resumed", detail, now)};
    if (open) {
        page_ = *open;
        chose_first_ = answered.back().response_first;
        const auto& condition = study_->conditions.at(plan_.condition_of(pair_));
        was_expected_ = answered.back().is_A_selected == (condition.expected == 'A');
        show(Screen::kQuestion);
    } else if (pair_ == pair_count()) {
        rows.emplace_back(CompleteSession{plan_.session_id, now.utc});
        show(Screen::kThanks);
    } else {
        show(instructions_read && !answered.empty() ? Screen::kPairs : Screen::kInstructions);
    }
    return rows;
}

}  // namespace obscura::app::kiosk
