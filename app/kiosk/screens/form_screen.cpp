// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>
// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <charconv>

#include "app/kiosk/screens/screens.h"
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

void age_field(FormDraft& draft, const FormProblems& problems) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Age in years");
    ImGui::SameLine();
    if (draft.focus_age) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(4.0F * ImGui::GetFontSize());
    ImGui::InputText("##age", &draft.age, ImGuiInputTextFlags_CharsDecimal);
    if (ImGui::IsItemActive()) {
        draft.focus_age = false;
        // Leaves the field, so that the arrow keys move on.
        if (ImGui::IsKeyPressed(GLFW_KEY_DOWN) || ImGui::IsKeyPressed(GLFW_KEY_TAB)) {
            ImGui::ClearActiveID();
        }
    }
    if (draft.submitted && !problems.age.empty()) complaint(problems.age);
}

void gender_field(FormDraft& draft) {
    const auto choice = [&draft](const char* label, Gender gender) {
        if (radio(label, draft.gender == gender)) draft.gender = gender;
    };
    const float apart = ImGui::GetFontSize() * 1.2F;
    paragraph("Gender");
    choice("Female", Gender::kFemale);
    ImGui::SameLine(0.0F, apart);
    choice("Male", Gender::kMale);
    ImGui::SameLine(0.0F, apart);
    choice("In my own words", Gender::kOwnWords);
    ImGui::SameLine(0.0F, apart);
    choice("Rather not say", Gender::kRatherNotSay);
    if (draft.gender == Gender::kOwnWords) {
        ImGui::SetNextItemWidth(-1.0F);
        ImGui::InputText("##gender", &draft.own_words);
    }
}

}  // namespace

Form form_of(const FormDraft& draft) {
    Form form;
    form.age_years = whole_number(draft.age);
    if (draft.gender == Gender::kFemale) form.gender = "female";
    if (draft.gender == Gender::kMale) form.gender = "male";
    if (draft.gender == Gender::kOwnWords) form.gender = draft.own_words;
    form.normal_vision = draft.normal_vision;
    if (draft.heard_of_purpose) form.naive = !*draft.heard_of_purpose;
    form.consent = draft.consent;
    return form;
}

std::optional<Event> form_screen(const Fonts& fonts, FormDraft& draft) {
    std::optional<Event> event;
    card("##form", 36.0F, [&] {
        const FormProblems problems = problems_of(form_of(draft));
        heading(fonts, "About you");
        age_field(draft, problems);
        gap(0.2F);
        gender_field(draft);
        gap(0.2F);
        yes_no("vision", "Is your vision normal, or corrected to normal by glasses or lenses?",
               draft.normal_vision);
        gap(0.2F);
        yes_no("purpose", "Had you heard what this study is about before today?",
               draft.heard_of_purpose);
        gap(0.2F);
        tick("I agree to take part", draft.consent);
        hint(fonts,
             "Your answers are stored without your name. You may stop at any time: tell the person "
             "in charge.");
        if (draft.submitted && !problems.consent.empty()) complaint(problems.consent);
        gap(0.4F);
        if (primary_button("Continue")) {
            draft.submitted = true;
            if (problems.none()) event = FormSubmitted{form_of(draft)};
            draft.focus_age = !problems.age.empty();
        }
    });
    return event;
}

}  // namespace obscura::app::kiosk
