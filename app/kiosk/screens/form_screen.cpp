// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <charconv>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

[[nodiscard]] std::optional<int> whole_number(const std::string& text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (text.empty() || error != std::errc() || stopped != end) return std::nullopt;
    return value;
}

/// What of an entry needs to be said.
void notes_on(const Fonts& fonts, const TextEntry& entry) {
    if (entry.note() == TextEntry::Note::kOnlyDigits) hint(fonts, words()("only_digits"));
    if (entry.note() == TextEntry::Note::kFull) {
        hint(fonts, words()("no_more_room", {{"count", std::to_string(entry.most())}}));
    }
    if (has_boxes(entry)) hint(fonts, words()("box_note"));
}

/// Puts the keyboard on the next field where it is to be there.
void focus_if_wanted(FormDraft& draft, FormDraft::ToFill field) {
    if (draft.to_fill != field) return;
    draft.to_fill = FormDraft::ToFill::kNothing;
    focus_next();
}

/// Digits for those who have a mouse or a finger only.
void number_pad(SideBySide& row, FormDraft& draft) {
    const float side = times_text(1.75F);
    const float apart = times_text(0.2F);
    row.next(11.0F * side + 10.0F * apart);
    const auto key = [&](const std::string& label) {
        const bool pressed = pad_button(label, side);
        if (pressed) draft.to_fill = FormDraft::ToFill::kAge;
        return pressed;
    };
    // Numbers are read from the left in every language.
    for (char digit = '0'; digit <= '9'; ++digit) {
        if (key({digit})) draft.age.type(static_cast<char32_t>(digit));
        ImGui::SameLine(0.0F, apart);
    }
    if (key("\u2190")) draft.age.erase_before();
}

void age_field(const Fonts& fonts, FormDraft& draft, const FormProblems& problems) {
    SideBySide row(ImGui::GetStyle().ItemSpacing.x);
    row_text(row, marked_required(words()("age")));
    focus_if_wanted(draft, FormDraft::ToFill::kAge);
    const float width = times_text(3.5F);
    row.next(width);
    text_field("##age", draft.age, width);
    number_pad(row, draft);
    notes_on(fonts, draft.age);
    if (draft.submitted && problems.age) {
        complaint(words()("age_problem", {{"least", std::to_string(kYoungest_years)},
                                          {"most", std::to_string(kOldest_years)}}));
    }
}

void gender_field(const Fonts& fonts, FormDraft& draft) {
    paragraph(words()("gender"));
    SideBySide row(ImGui::GetFontSize() * 1.2F);
    const auto choice = [&](const char* label, Gender gender) {
        const bool pressed = radio(row, words()(label), draft.gender == gender);
        if (pressed) draft.gender = gender;
        return pressed;
    };
    (void)choice("female", Gender::kFemale);
    (void)choice("male", Gender::kMale);
    const bool own_words = choice("own_words", Gender::kOwnWords);
    (void)choice("rather_not_say", Gender::kRatherNotSay);
    if (draft.gender != Gender::kOwnWords) return;
    // It takes the typing at once.
    if (own_words) draft.to_fill = FormDraft::ToFill::kOwnWords;
    focus_if_wanted(draft, FormDraft::ToFill::kOwnWords);
    text_field("##gender", draft.own_words, ImGui::GetContentRegionAvail().x);
    keypad("##gender", draft.own_words);
    notes_on(fonts, draft.own_words);
}

void kiosks_questions(const Fonts& fonts, FormDraft& draft, const FormProblems& problems) {
    hint(fonts, words()("required_note"));
    gap(0.2F);
    age_field(fonts, draft, problems);
    gap(0.2F);
    gender_field(fonts, draft);
    gap(0.2F);
    yes_no("vision", words()("vision"), draft.normal_vision);
    gap(0.2F);
    yes_no("purpose", words()("heard_of"), draft.heard_of_purpose);
    gap(0.2F);
}

void consent_tick(const Fonts& fonts, FormDraft& draft, const FormProblems& problems) {
    focus_if_wanted(draft, FormDraft::ToFill::kConsent);
    tick(marked_required(words()("consent")), draft.consent);
    hint(fonts, words()("consent_hint"));
    if (draft.submitted && problems.consent) complaint(words()("consent_problem"));
}

/// Moves the keyboard to the first that is still to be filled in.
void go_to_problem(const FormProblems& left, const stimuli::Study& study, FormDraft& draft) {
    if (left.fields) {
        for (std::size_t i = 0; i < draft.fields.size(); ++i) {
            const FieldAnswer answer = answer_in(study.form[i], draft.fields[i]);
            if (problem_of(study.form[i], answer) == FieldProblem::kNone) continue;
            draft.fields[i].to_fill = true;
            return;
        }
    }
    draft.to_fill = left.age ? FormDraft::ToFill::kAge : FormDraft::ToFill::kConsent;
}

}  // namespace

Form form_of(const FormDraft& draft, const stimuli::Study& study) {
    Form form;
    form.consent = draft.consent;
    if (!study.form.empty()) {
        for (std::size_t i = 0; i < study.form.size() && i < draft.fields.size(); ++i) {
            form.fields.push_back(answer_in(study.form[i], draft.fields[i]));
        }
        return form;
    }
    form.age_years = whole_number(draft.age.utf8());
    if (draft.gender == Gender::kFemale) form.gender = "female";
    if (draft.gender == Gender::kMale) form.gender = "male";
    if (draft.gender == Gender::kOwnWords) form.gender = draft.own_words.utf8();
    if (draft.gender == Gender::kRatherNotSay) form.gender = kRatherNotSayStored;
    form.normal_vision = draft.normal_vision;
    if (draft.heard_of_purpose) form.naive = !*draft.heard_of_purpose;
    return form;
}

std::optional<Event> form_screen(const Fonts& fonts, const stimuli::Study& study, FormDraft& draft,
                                 const std::vector<std::string>& known_codes) {
    std::optional<Event> event;
    const FormProblems problems = problems_of(form_of(draft, study), study);
    card(
        "##form", 40.0F,
        [&] {
            heading(fonts, words()("about_you"));
            if (study.form.empty()) {
                kiosks_questions(fonts, draft, problems);
            } else {
                draw_fields(fonts, study.form, draft, known_codes);
            }
            if (!study.consent) consent_tick(fonts, draft, problems);
        },
        [&] {
            if (!primary_button(words()("continue"))) return;
            draft.submitted = true;
            const Form form = form_of(draft, study);
            const FormProblems left = problems_of(form, study);
            if (left.none()) {
                event = FormSubmitted{form};
            } else {
                go_to_problem(left, study, draft);
            }
        });
    return event;
}

}  // namespace obscura::app::kiosk
