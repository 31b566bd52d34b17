// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What the rows of a procedure say.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/kiosk/procedure.h"
#include "stimuli/questions.h"
#include "stimuli/variant_names.h"

namespace obscura::app::kiosk {
namespace {

constexpr double kMsPerS = 1000.0;

[[nodiscard]] analysis::Kind kind_of(const stimuli::Condition& condition, analysis::Kind session) {
    if (condition.practice) return analysis::Kind::kPractice;
    return condition.expected != '\0' ? analysis::Kind::kCatch : session;
}

[[nodiscard]] bool is_beside(const stimuli::Study& study) {
    return study.presentation.layout == stimuli::Layout::kSideBySide;
}

}  // namespace

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

analysis::SessionRecord Procedure::session_record(const Moment& now) const {
    return {.session_id = plan_.session_id,
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
            .condition_count = static_cast<int>(plan_.order.conditions.size()),
            .state = analysis::SessionState::kOpen,
            .started_utc = now.utc,
            .ended_utc = "",
            .software = plan_.machine.software,
            .operating_system = plan_.machine.operating_system,
            .gpu_renderer = plan_.machine.gpu_renderer,
            .display = plan_.machine.display,
            .refresh_hz = plan_.machine.refresh_hz,
            .exclusion = study_->exclusion.to_json(),
            .study_plan = stimuli::plan_json(*study_, plan_.questions),
            .timing = plan_.machine.timing};
}

analysis::TrialRecord Procedure::trial_record(bool first, const Moment& now) const {
    const stimuli::Condition& condition = study_->conditions.at(plan_.condition_of(pair_));
    const stimuli::StudyScene& scene = study_->scene_of(condition);
    const bool a_first = !plan_.b_first(pair_);
    analysis::TrialRecord row;
    row.session_id = plan_.session_id;
    row.kind = kind_of(condition, plan_.kind);
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
    row.first_view_ms = trial_.first_view_s * kMsPerS;
    row.second_view_ms = trial_.second_view_s * kMsPerS;
    row.grey_ms_measured =
        is_beside(*study_) ? 0.0 : (trial_.second_onset_s - trial_.interval_onset_s) * kMsPerS;
    row.dropped_frames = trial_.dropped_frames;
    row.hidden_ms = trial_.hidden_s * kMsPerS;
    row.first_sha256 = image(pair_, 0).sha256;
    row.second_sha256 = image(pair_, 1).sha256;
    row.answered_utc = now.utc;
    row.expected = condition.practice ? '\0' : condition.expected;
    row.repeats = condition.repeats;
    row.override_reason = plan_.override_reason;
    return row;
}

std::string Procedure::place() const {
    const Progress at = progress();
    const std::string pair = fmt::format("{}pair {}", at.practice ? "practice " : "", at.pair + 1);
    switch (screen_ == Screen::kConfirmLeave ? covered_ : screen_) {
        case Screen::kFirstImage:
            return pair + ", first image";
        case Screen::kInterval:
            return pair + ", interval";
        case Screen::kBothImages:
            return pair + ", both images";
        case Screen::kSecondImage:
            return pair + ", second image";
        case Screen::kQuestion:
            return pair + (page_ == 0 ? ", question" : ", question " + asked().question->id);
        default:
            return "between the pairs";
    }
}

analysis::EventRecord Procedure::event_record(std::string name, std::string detail,
                                              const Moment& now) const {
    return {.session_id = began_ ? plan_.session_id : "",
            .time_utc = now.utc,
            .name = std::move(name),
            .detail = std::move(detail)};
}

}  // namespace obscura::app::kiosk
