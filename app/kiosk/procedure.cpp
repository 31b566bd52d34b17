// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/procedure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "renderer/base/error.h"
#include "stimuli/variant_names.h"

namespace obscura::app::kiosk {
namespace {

constexpr double kMillisecondsPerSecond = 1000.0;

template <typename T>
[[nodiscard]] bool is(const Event& event) {
    return std::holds_alternative<T>(event);
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
    : study_(&study), plan_(std::move(plan)), latest_s_(-std::numeric_limits<double>::infinity()) {}

void Procedure::change_order(stimuli::SessionOrder order) {
    assert(pair_ == 0 && order.conditions.size() == plan_.order.conditions.size());
    plan_.order = std::move(order);
}

const StimulusImage& Procedure::image(int pair, int position) const {
    const auto condition = static_cast<std::size_t>(plan_.order.conditions.at(pair));
    const std::size_t side =
        (position == 0) == plan_.order.b_first(static_cast<std::size_t>(pair)) ? 1 : 0;
    return plan_.images.at(condition).at(side);
}

std::optional<double> Procedure::second_image_due_s() const {
    if (screen_ != Screen::kGrey || !visible_) return std::nullopt;
    return trial_.grey_onset_s + study_->grey_ms / kMillisecondsPerSecond;
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
    takes_presses_from_s_ = time_s + study_->input_delay_ms / kMillisecondsPerSecond;
    end_seen_ = event.end_in_view;
    // Grey that the operator's question interrupted starts anew; other screens keep their onset.
    if (screen_ == Screen::kGrey) trial_.grey_onset_s = time_s;
    if (first_time_) {
        if (screen_ == Screen::kFirstImage) trial_.first_onset_s = time_s;
        if (screen_ == Screen::kSecondImage) trial_.second_onset_s = time_s;
        if (screen_ == Screen::kQuestion) trial_.question_onset_s = time_s;
    }
    if (screen_ != Screen::kConfirmLeave) {
        if (gone_since_s_) trial_.hidden_s += time_s - *gone_since_s_;
        gone_since_s_.reset();
        first_time_ = false;
        trial_.dropped_frames += event.dropped_frames;
    }
}

/// What made the page scroll to its end does not leave it as well.
void Procedure::end_came_into_view(double time_s) {
    if (end_seen_) return;
    end_seen_ = true;
    takes_presses_from_s_ =
        std::max(takes_presses_from_s_, time_s + study_->input_delay_ms / kMillisecondsPerSecond);
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
                if (pressed->pair == pair_) {
                    trial_ = {};
                    show(Screen::kFirstImage);
                }
            }
            break;
        case Screen::kFirstImage:
            if (is<SpacePressed>(event)) {
                trial_.first_view_s = seen_s(now.time_s);
                show(Screen::kGrey);
            }
            break;
        case Screen::kGrey:
            if (const auto* tick = std::get_if<Tick>(&event)) {
                if (tick->expected_onset_s >= *second_image_due_s()) show(Screen::kSecondImage);
            }
            break;
        case Screen::kSecondImage:
            if (is<SpacePressed>(event)) {
                trial_.second_view_s = seen_s(now.time_s);
                show(Screen::kQuestion);
            }
            break;
        case Screen::kQuestion:
            if (const auto* answered = std::get_if<Answered>(&event)) {
                return answer(answered->first, now);
            }
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

analysis::ParticipantRecord Procedure::participant_record(const Form& form,
                                                          const Moment& now) const {
    analysis::ParticipantRecord record{.participant_id = plan_.participant_id,
                                       .kind = plan_.kind,
                                       .age_years = form.age_years,
                                       .gender = form.gender,
                                       .normal_vision = form.normal_vision,
                                       .naive = form.naive,
                                       .consent = form.consent || study_->consent.has_value(),
                                       .created_utc = now.utc};
    if (study_->consent) {
        record.consent_version = study_->consent->version;
        record.consent_items = nlohmann::json(study_->consent->items).dump();
        record.consent_utc = consent_utc_;
    }
    if (study_->form.empty()) return record;
    record.form = form_json(study_->form, form.fields);
    record.code = code_in(study_->form, form.fields);
    // What the kiosk asks itself has its own columns.
    for (std::size_t i = 0; i < study_->form.size() && i < form.fields.size(); ++i) {
        const stimuli::FormField& field = study_->form[i];
        const std::string text = trimmed(form.fields[i].text);
        const auto number = number_in(text);
        if (field.id == "age" && field.kind == stimuli::FieldKind::kNumber && number &&
            *number >= kYoungest_years && *number <= kOldest_years) {
            record.age_years = static_cast<int>(*number);
        }
        const bool in_words =
            field.kind == stimuli::FieldKind::kText || field.kind == stimuli::FieldKind::kChoice;
        if (field.id == "gender" && in_words) record.gender = text;
    }
    return record;
}

std::vector<Row> Procedure::begin(const Form& form, const Moment& now) {
    const bool code_was_known = screen_ == Screen::kKnownCode;
    began_ = true;
    began_s_ = now.time_s;
    BeginSession rows;
    rows.participant = participant_record(form, now);
    rows.session = {.session_id = plan_.session_id,
                    .participant_id = plan_.participant_id,
                    .kind = plan_.kind,
                    .study = study_->name,
                    .study_sha256 = study_->sha256,
                    .order = std::string(stimuli::to_string(study_->order)),
                    .seed = study_->seed,
                    .slot = plan_.order.slot,
                    .latin_square = plan_.order.latin_square,
                    .latin_row = plan_.order.latin_row,
                    .swapped = plan_.order.swapped,
                    .condition_count = pair_count(),
                    .state = analysis::SessionState::kOpen,
                    .started_utc = now.utc,
                    .ended_utc = "",
                    .software = plan_.machine.software,
                    .operating_system = plan_.machine.operating_system,
                    .gpu_renderer = plan_.machine.gpu_renderer,
                    .display = plan_.machine.display,
                    .refresh_hz = plan_.machine.refresh_hz,
                    .exclusion = study_->exclusion.to_json(),
                    .study_plan = study_->plan_json()};
    rows.events = {event_record(kStimuliEvent, digest_of(plan_.images), now)};
    if (code_was_known) {
        rows.events.push_back(event_record("code known", "the operator went on with it", now));
    }
    show(Screen::kInstructions);
    return {std::move(rows)};
}

std::vector<Row> Procedure::answer(bool first, const Moment& now) {
    std::vector<Row> rows{trial_record(first, now)};
    ++pair_;
    if (pair_ < pair_count()) {
        show(Screen::kPairs);
    } else {
        show(Screen::kThanks);
        rows.emplace_back(CompleteSession{plan_.session_id, now.utc});
    }
    return rows;
}

analysis::TrialRecord Procedure::trial_record(bool first, const Moment& now) const {
    const auto index = static_cast<std::size_t>(plan_.order.conditions.at(pair_));
    const stimuli::Condition& condition = study_->conditions.at(index);
    const stimuli::StudyScene& scene = study_->scene_of(condition);
    const bool a_first = !plan_.order.b_first(static_cast<std::size_t>(pair_));
    analysis::TrialRecord row;
    row.session_id = plan_.session_id;
    row.kind = condition.expected != '\0' ? analysis::Kind::kCatch : plan_.kind;
    row.trial_index = pair_;
    row.condition = condition.id;
    row.hypothesis = condition.hypothesis;
    row.scene = scene.id;
    row.validity = std::string(stimuli::to_string(scene.validity));
    const stimuli::VariantNames names = stimuli::variant_names(*study_);
    row.condition_A = names.at({condition.id, 'a'});
    row.condition_B = names.at({condition.id, 'b'});
    row.first_shown = a_first ? 'A' : 'B';
    row.response_first = first;
    row.is_A_selected = first == a_first;
    row.response_time_s = seen_s(now.time_s);
    row.first_onset_s = trial_.first_onset_s - began_s_;
    row.second_onset_s = trial_.second_onset_s - began_s_;
    row.question_onset_s = trial_.question_onset_s - began_s_;
    row.first_view_ms = trial_.first_view_s * kMillisecondsPerSecond;
    row.second_view_ms = trial_.second_view_s * kMillisecondsPerSecond;
    row.grey_ms_measured = (trial_.second_onset_s - trial_.grey_onset_s) * kMillisecondsPerSecond;
    row.dropped_frames = trial_.dropped_frames;
    row.hidden_ms = trial_.hidden_s * kMillisecondsPerSecond;
    row.first_sha256 = image(pair_, 0).sha256;
    row.second_sha256 = image(pair_, 1).sha256;
    row.answered_utc = now.utc;
    row.expected = condition.expected;
    row.repeats = condition.repeats;
    return row;
}

std::string Procedure::place() const {
    const std::string pair = fmt::format("pair {}", pair_ + 1);
    switch (screen_ == Screen::kConfirmLeave ? covered_ : screen_) {
        case Screen::kFirstImage:
            return pair + ", first image";
        case Screen::kGrey:
            return pair + ", grey interval";
        case Screen::kSecondImage:
            return pair + ", second image";
        case Screen::kQuestion:
            return pair + ", question";
        default:
            return "between the pairs";
    }
}

void Procedure::go_out_of_sight(double time_s) {
    seen_before_s_ = seen_s(time_s);
    visible_ = false;
    takes_presses_from_s_ = std::numeric_limits<double>::infinity();
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

analysis::EventRecord Procedure::event_record(std::string name, std::string detail,
                                              const Moment& now) const {
    return {.session_id = began_ ? plan_.session_id : "",
            .time_utc = now.utc,
            .name = std::move(name),
            .detail = std::move(detail)};
}

std::vector<Row> Procedure::resume(const std::vector<analysis::TrialRecord>& answered,
                                   bool instructions_read, double elapsed_s, const Moment& now) {
    if (static_cast<int>(answered.size()) > pair_count()) {
        throw base::bad_input("session {} has {} answers, the study has {} pairs", plan_.session_id,
                              answered.size(), pair_count());
    }
    for (std::size_t i = 0; i < answered.size(); ++i) {
        const auto index = static_cast<std::size_t>(plan_.order.conditions.at(i));
        const std::string& expected = study_->conditions.at(index).id;
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
    const std::string detail = fmt::format(
        "at pair {} of {}, on {}; {}; {}", std::min(pair_ + 1, pair_count()), pair_count(),
        plan_.machine.software, plan_.machine.gpu_renderer, plan_.machine.display);
    std::vector<Row> rows{event_record("session resumed", detail, now)};
    if (pair_ == pair_count()) {
        rows.emplace_back(CompleteSession{plan_.session_id, now.utc});
        show(Screen::kThanks);
    } else {
        show(instructions_read && !answered.empty() ? Screen::kPairs : Screen::kInstructions);
    }
    return rows;
}

}  // namespace obscura::app::kiosk
