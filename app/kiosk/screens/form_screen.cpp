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
    if (!entry.note().empty()) hint(fonts, entry.note());
    if (has_boxes(entry)) {
        hint(fonts,
             "\u25A1 stands for a character that this screen cannot draw. It is stored as you "
             "typed it.");
    }
}

/// Puts the keyboard on the next field where it is to be there.
void focus_if_wanted(FormDraft& draft, FormDraft::ToFill field) {
    if (draft.to_fill != field) return;
    draft.to_fill = FormDraft::ToFill::kNothing;
    focus_next();
}

/// Digits for those who have a mouse or a finger only.
void number_pad(FormDraft& draft) {
    const float side = 1.75F;
    const float apart = 0.2F * ImGui::GetFontSize();
    const auto key = [&](const char* label) {
        ImGui::SameLine(0.0F, apart);
        const bool pressed =
            ImGui::Button(label, {side * ImGui::GetFontSize(), ImGui::GetFrameHeight()});
        if (pressed) draft.to_fill = FormDraft::ToFill::kAge;
        return pressed;
    };
    for (char digit = '0'; digit <= '9'; ++digit) {
        const char label[] = {digit, '\0'};
        if (key(label)) draft.age.type(static_cast<char32_t>(digit));
    }
    if (key("\u2190")) draft.age.erase_before();
}

void age_field(const Fonts& fonts, FormDraft& draft, const FormProblems& problems) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Age in years");
    ImGui::SameLine();
    focus_if_wanted(draft, FormDraft::ToFill::kAge);
    text_field("##age", draft.age, 3.5F * ImGui::GetFontSize());
    number_pad(draft);
    notes_on(fonts, draft.age);
    if (draft.submitted && !problems.age.empty()) complaint(problems.age);
}

void gender_field(const Fonts& fonts, FormDraft& draft) {
    const auto choice = [&draft](const char* label, Gender gender) {
        const bool pressed = radio(label, draft.gender == gender);
        if (pressed) draft.gender = gender;
        return pressed;
    };
    const float apart = ImGui::GetFontSize() * 1.2F;
    paragraph("Gender");
    (void)choice("Female", Gender::kFemale);
    ImGui::SameLine(0.0F, apart);
    (void)choice("Male", Gender::kMale);
    ImGui::SameLine(0.0F, apart);
    const bool own_words = choice("In my own words", Gender::kOwnWords);
    ImGui::SameLine(0.0F, apart);
    (void)choice("Rather not say", Gender::kRatherNotSay);
    if (draft.gender != Gender::kOwnWords) return;
    // It takes the typing at once.
    if (own_words) draft.to_fill = FormDraft::ToFill::kOwnWords;
    focus_if_wanted(draft, FormDraft::ToFill::kOwnWords);
    text_field("##gender", draft.own_words, ImGui::GetContentRegionAvail().x);
    notes_on(fonts, draft.own_words);
}

void questions(const Fonts& fonts, FormDraft& draft, const FormProblems& problems) {
    heading(fonts, "About you");
    age_field(fonts, draft, problems);
    gap(0.2F);
    gender_field(fonts, draft);
    gap(0.2F);
    yes_no("vision", "Is your vision normal, or corrected to normal by glasses or lenses?",
           draft.normal_vision);
    gap(0.2F);
    yes_no("purpose", "Had you heard what this study is about before today?",
           draft.heard_of_purpose);
    gap(0.2F);
    focus_if_wanted(draft, FormDraft::ToFill::kConsent);
    tick("I agree to take part", draft.consent);
    hint(fonts,
         "Your answers are stored without your name. You may stop at any time: tell the person "
         "in charge.");
    if (draft.submitted && !problems.consent.empty()) complaint(problems.consent);
}

}  // namespace

Form form_of(const FormDraft& draft) {
    Form form;
    form.age_years = whole_number(draft.age.utf8());
    if (draft.gender == Gender::kFemale) form.gender = "female";
    if (draft.gender == Gender::kMale) form.gender = "male";
    if (draft.gender == Gender::kOwnWords) form.gender = draft.own_words.utf8();
    if (draft.gender == Gender::kRatherNotSay) form.gender = kRatherNotSayStored;
    form.normal_vision = draft.normal_vision;
    if (draft.heard_of_purpose) form.naive = !*draft.heard_of_purpose;
    form.consent = draft.consent;
    return form;
}

std::optional<Event> form_screen(const Fonts& fonts, FormDraft& draft) {
    std::optional<Event> event;
    const FormProblems problems = problems_of(form_of(draft));
    card(
        "##form", 36.0F, [&] { questions(fonts, draft, problems); },
        [&] {
            if (!primary_button("Continue")) return;
            draft.submitted = true;
            const Form form = form_of(draft);
            const FormProblems left = problems_of(form);
            if (left.none()) {
                event = FormSubmitted{form};
            } else {
                draft.to_fill =
                    left.age.empty() ? FormDraft::ToFill::kConsent : FormDraft::ToFill::kAge;
            }
        });
    return event;
}

}  // namespace obscura::app::kiosk
