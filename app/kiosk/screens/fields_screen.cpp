// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The form as a study asks it, in place of the kiosk's own.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

using stimuli::FieldKind;
using stimuli::FormField;

void notes_on_entry(const Fonts& fonts, const TextEntry& entry) {
    if (entry.note() == TextEntry::Note::kFull) {
        hint(fonts, words()("no_more_room", {{"count", std::to_string(entry.most())}}));
    }
    if (has_boxes(entry)) hint(fonts, words()("box_note"));
}

[[nodiscard]] std::string complaint_on(const FormField& field, FieldProblem problem) {
    const auto shown = [](double value) { return fmt::format("{}", value); };
    if (problem == FieldProblem::kMissing) return words()("field_missing");
    if (problem == FieldProblem::kNoNumber) return words()("field_no_number");
    if (field.min && field.max) {
        return words()("field_between",
                       {{"least", shown(*field.min)}, {"most", shown(*field.max)}});
    }
    if (field.min) return words()("field_at_least", {{"least", shown(*field.min)}});
    return words()("field_at_most", {{"most", shown(*field.max)}});
}

/// One button for each of a few texts, of which one can be chosen, and taken back.
void one_of(const std::vector<std::string>& texts, std::string& chosen) {
    SideBySide row(ImGui::GetFontSize() * 1.2F);
    for (const std::string& text : texts) {
        if (radio(row, text, chosen == text)) chosen = chosen == text ? "" : text;
    }
}

void scale(const Fonts& fonts, const FormField& field, std::string& chosen) {
    std::vector<std::string> steps;
    for (int step = static_cast<int>(*field.min); step <= static_cast<int>(*field.max); ++step) {
        steps.push_back(std::to_string(step));
    }
    one_of(steps, chosen);
    if (field.labels.size() != 2) return;
    hint(fonts, fmt::format("{} = {}, {} = {}", steps.front(), field.labels[0], steps.back(),
                            field.labels[1]));
}

void some_of(const std::vector<std::string>& texts, FieldDraft& draft) {
    draft.ticked.resize(texts.size(), false);
    for (std::size_t i = 0; i < texts.size(); ++i) tick(texts[i], draft.ticked[i]);
}

void code_button(SideBySide& row, TextEntry& entry, const std::vector<std::string>& known_codes) {
    const std::string label = words()("make_code");
    const float width = std::ceil(text_width(label)) + times_text(2.0F);
    row.next(width);
    if (!wide_button(label, width, 0.0F, false)) return;
    entry = TextEntry(stimuli::kLongestFieldText);
    for (const char letter : make_code(known_codes)) entry.type(static_cast<char32_t>(letter));
}

void entry_field(
    const Fonts& fonts, const FormField& field, FieldDraft& draft,
    const std::function<void(SideBySide&)>& beside = [](SideBySide& /*row*/) {}) {
    const bool number = field.kind == FieldKind::kNumber;
    SideBySide row(ImGui::GetStyle().ItemSpacing.x);
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = number                           ? times_text(7.0F)
                        : field.kind == FieldKind::kCode ? std::min(room, times_text(14.0F))
                                                         : room;
    row.next(width);
    text_field("##entry", draft.entry, width);
    if (number && !field.unit.empty()) row_text(row, field.unit);
    beside(row);
    if (!number) {
        keypad("##entry", draft.entry,
               field.kind == FieldKind::kCode ? KeypadLetters::kLatin : KeypadLetters::kOfLanguage);
    }
    notes_on_entry(fonts, draft.entry);
}

/// Digits for those who have a mouse or a finger only.
void digits_for(const FormField& field, FieldDraft& draft) {
    const float side = times_text(1.75F);
    const float apart = times_text(0.2F);
    const bool negative = !field.min || *field.min < 0.0;
    const float keys = negative ? 13.0F : 12.0F;
    SideBySide row(0.0F);
    row.next(keys * side + (keys - 1.0F) * apart);
    const auto key = [&](const std::string& label, char32_t character) {
        if (pad_button(label, side)) {
            draft.entry.type(character);
            draft.to_fill = true;
        }
        ImGui::SameLine(0.0F, apart);
    };
    for (char32_t digit = U'0'; digit <= U'9'; ++digit) key(utf8_of(digit), digit);
    key(".", U'.');
    if (negative) key("-", U'-');
    if (pad_button("\u2190", side)) draft.entry.erase_before();
}

void draw_field(const Fonts& fonts, const FormField& field, FieldDraft& draft,
                const std::vector<std::string>& known_codes) {
    paragraph(field.required ? marked_required(field.label) : field.label);
    if (std::exchange(draft.to_fill, false)) focus_next();
    switch (field.kind) {
        case FieldKind::kChoice:
            one_of(field.choices, draft.chosen);
            break;
        case FieldKind::kScale:
            scale(fonts, field, draft.chosen);
            break;
        case FieldKind::kChoices:
            some_of(field.choices, draft);
            break;
        case FieldKind::kNumber:
            entry_field(fonts, field, draft);
            digits_for(field, draft);
            break;
        case FieldKind::kText:
            entry_field(fonts, field, draft);
            break;
        case FieldKind::kCode:
            entry_field(fonts, field, draft, [&](SideBySide& row) {
                if (field.generate) code_button(row, draft.entry, known_codes);
            });
            break;
    }
}

}  // namespace

FieldAnswer answer_in(const FormField& field, const FieldDraft& draft) {
    FieldAnswer answer;
    switch (field.kind) {
        case FieldKind::kChoice:
        case FieldKind::kScale:
            answer.text = draft.chosen;
            break;
        case FieldKind::kChoices:
            for (std::size_t i = 0; i < draft.ticked.size(); ++i) {
                if (draft.ticked[i]) answer.chosen.push_back(field.choices[i]);
            }
            break;
        case FieldKind::kText:
        case FieldKind::kNumber:
        case FieldKind::kCode:
            answer.text = draft.entry.utf8();
            break;
    }
    return answer;
}

void draw_fields(const Fonts& fonts, const std::vector<FormField>& fields, FormDraft& draft,
                 const std::vector<std::string>& known_codes) {
    draft.fields.resize(fields.size());
    if (std::any_of(fields.begin(), fields.end(), [](const auto& one) { return one.required; })) {
        hint(fonts, words()("required_note"));
        gap(0.2F);
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        draw_field(fonts, fields[i], draft.fields[i], known_codes);
        const FieldProblem problem = problem_of(fields[i], answer_in(fields[i], draft.fields[i]));
        if (draft.submitted && problem != FieldProblem::kNone) {
            complaint(complaint_on(fields[i], problem));
        }
        gap(0.2F);
        ImGui::PopID();
    }
}

}  // namespace obscura::app::kiosk
