// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/kiosk/key_names.h"
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

using stimuli::Question;
using stimuli::QuestionKind;

/// An answer's button with its key, unless the page's hint says the keys or the label is its key.
[[nodiscard]] std::string button_text(const stimuli::Study& study, const AskedPage& page,
                                      int answer, bool with_key) {
    const std::string label = label_of(study, page, answer);
    const std::string key = with_key ? shown_key(page, answer) : "";
    return key.empty() || key == label ? label : fmt::format("{} ({})", label, key);
}

[[nodiscard]] Event pressed(const AskedPage& page, int answer) {
    if (page.question == nullptr) return Answered{answer == 0};
    return AnswerPressed{answer};
}

/// The two images side by side, and below them that there is no difference.
void image_buttons(const stimuli::Study& study, const AskedPage& page, bool with_keys,
                   std::optional<Event>& event) {
    const float space = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = std::floor((room - space) * 0.5F);
    SideBySide row(space);
    for (int answer = 0; answer < 2; ++answer) {
        row.next(width);
        if (wide_button(button_text(study, page, answer, with_keys), width, 4.0F, true)) {
            event = pressed(page, answer);
        }
    }
    if (page.answer_count() < 3) return;
    if (wide_button(button_text(study, page, 2, with_keys), room, 2.6F, false)) {
        event = pressed(page, 2);
    }
}

/// A scale whose ends have a name: a row of numbers.
void number_buttons(const stimuli::Study& study, const AskedPage& page,
                    std::optional<Event>& event) {
    const int count = page.answer_count();
    const float space = std::floor(ImGui::GetFontSize() * 0.4F);
    const float room = ImGui::GetContentRegionAvail().x;
    const auto steps = static_cast<float>(count);
    const float width = std::floor((room - (steps - 1.0F) * space) / steps);
    SideBySide row(space);
    for (int answer = 0; answer < count; ++answer) {
        const std::string step = std::to_string(page.question->min + answer);
        const std::string key = shown_key(page, answer);
        row.next(width);
        if (wide_button(key == step || key == "0" ? step : fmt::format("{} ({})", step, key), width,
                        3.0F, true)) {
            event = pressed(page, answer);
        }
    }
    const std::string low = label_of(study, page, 0);
    const std::string high = label_of(study, page, count - 1);
    const float taken = std::ceil(text_width(low)) + std::ceil(text_width(high));
    const float apart = ImGui::GetContentRegionAvail().x - taken - 2.0F;
    if (apart > ImGui::GetFontSize()) {
        SideBySide ends(apart);
        row_text(ends, low);
        row_text(ends, high);
    } else {
        paragraph(fmt::format("{} = {}", page.question->min, low));
        paragraph(fmt::format("{} = {}", page.question->max, high));
    }
}

/// A scale with a text for each step: one below the other.
void step_buttons(const stimuli::Study& study, const AskedPage& page, std::optional<Event>& event) {
    const float room = ImGui::GetContentRegionAvail().x;
    for (int answer = 0; answer < page.answer_count(); ++answer) {
        if (wide_button(button_text(study, page, answer, true), room, 2.1F, true)) {
            event = pressed(page, answer);
        }
    }
}

[[nodiscard]] bool has_step_texts(const AskedPage& page) {
    return page.question != nullptr && page.question->is_scale() &&
           static_cast<int>(page.question->labels.size()) == page.answer_count();
}

}  // namespace

std::optional<Event> question_screen(const Fonts& fonts, const stimuli::Study& study,
                                     const Progress& at, const AskedPage& page) {
    std::optional<Event> event;
    const bool beside = study.presentation.layout == stimuli::Layout::kSideBySide;
    const bool is_scale = page.question != nullptr && page.question->is_scale();
    // The thesis's question has a hint of its own.
    const bool plain = page.question == nullptr ||
                       (page.question->keys.empty() && !is_scale && page.answer_count() == 2);
    const auto body = [&] {
        hint(fonts,
             words()(at.practice ? "practice_pair_of" : "pair_of",
                     {{"pair", std::to_string(at.pair + 1)}, {"count", std::to_string(at.count)}}));
        // Nothing else tells the page of the second image from that of the first.
        if (page.image != 0) heading(fonts, name_of_image(study, page.image));
        heading(fonts, page.question == nullptr ? study.question : page.question->text);
        if (has_step_texts(page)) step_buttons(study, page, event);
    };
    const auto foot = [&] {
        if (is_scale && !has_step_texts(page)) number_buttons(study, page, event);
        if (!is_scale) image_buttons(study, page, !plain, event);
        gap(0.3F);
        const char* const usual = beside ? "question_hint_beside" : "question_hint";
        hint(fonts, words()(plain ? usual : "answer_hint"));
    };
    // What ended the look at the second image must not press a button here.
    card("##question", 34.0F, body, foot, Keyboard::kIsLeftToTheCaller);
    return event;
}

}  // namespace obscura::app::kiosk
