// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> information_screen(const Fonts& fonts, const stimuli::Study& study) {
    std::optional<Event> event;
    card(
        "##information", 36.0F,
        [&] {
            heading(fonts, words()("information"));
            paragraph(study.information);
        },
        [&] {
            if (primary_button(words()("continue"))) event = InformationRead{};
        });
    return event;
}

std::optional<Event> consent_screen(const Fonts& fonts, const stimuli::Consent& consent,
                                    FormDraft& draft) {
    std::optional<Event> event;
    draft.agreed.resize(consent.items.size(), false);
    const auto all = [&] {
        return std::all_of(draft.agreed.begin(), draft.agreed.end(), [](bool is) { return is; });
    };
    card(
        "##consent", 36.0F,
        [&] {
            heading(fonts, words()("consent_title"));
            if (!consent.text.empty()) {
                paragraph(consent.text);
                gap(0.2F);
            }
            paragraph(words()("consent_items_hint"));
            for (std::size_t i = 0; i < consent.items.size(); ++i) {
                gap(0.2F);
                ImGui::PushID(static_cast<int>(i));
                tick(consent.items[i], draft.agreed[i]);
                ImGui::PopID();
            }
            if (draft.asked_for_consent && !all()) complaint(words()("consent_problem"));
        },
        [&] {
            if (!primary_button(words()("continue"))) return;
            draft.asked_for_consent = true;
            if (all()) event = ConsentGiven{};
        });
    return event;
}

std::optional<Event> known_code_screen(const Fonts& fonts, const std::string& code) {
    std::optional<Event> event;
    card(
        "##known-code", 34.0F,
        [&] {
            heading(fonts, words()("code_known"));
            paragraph(words()("code_known_text", {{"code", code}}));
            paragraph(words()("call_operator"));
        },
        [&] {
            if (primary_button(words()("back"))) event = CodeTakenBack{};
            gap(0.2F);
            hint(fonts, words()("code_known_keys"));
        });
    return event;
}

}  // namespace obscura::app::kiosk
