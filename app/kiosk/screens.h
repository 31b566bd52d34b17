// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/kiosk/procedure.h"
#include "app/kiosk/text_entry.h"
#include "app/kiosk/window.h"
#include "app/window/fonts.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

using window::Fonts;

// One page a file. Each draws itself with Dear ImGui and gives back what was pressed, if anything.

[[nodiscard]] std::optional<Event> start_screen(const Fonts& fonts);

enum class Gender { kUnanswered, kFemale, kMale, kOwnWords, kRatherNotSay };

/// Of the gender in own words, in characters.
inline constexpr std::size_t kLongestOwnWords = 100;

/// The form as it is being filled in.
struct FormDraft {
    /// What the keyboard is to fill in next.
    enum class ToFill { kNothing, kAge, kOwnWords, kConsent };

    TextEntry age{3, TextEntry::Takes::kDigits};
    Gender gender = Gender::kUnanswered;
    TextEntry own_words{kLongestOwnWords};
    std::optional<bool> normal_vision;
    std::optional<bool> heard_of_purpose;
    bool consent = false;
    bool submitted = false;  ///< once; from then on complaints are shown
    ToFill to_fill = ToFill::kNothing;
};
[[nodiscard]] Form form_of(const FormDraft& draft);
[[nodiscard]] std::optional<Event> form_screen(const Fonts& fonts, FormDraft& draft);

[[nodiscard]] std::optional<Event> instructions_screen(const Fonts& fonts,
                                                       const stimuli::Study& study);

/// `next` is the pair whose button is enabled, from 0.
[[nodiscard]] std::optional<Event> pairs_screen(const Fonts& fonts, int next, int count);

[[nodiscard]] std::optional<Event> question_screen(const Fonts& fonts, const stimuli::Study& study,
                                                   int pair, int count);

/// Only the operator leaves it, by a key. `saved_note` says that the answers are saved, and where.
void thanks_screen(const Fonts& fonts, const stimuli::Study& study, const std::string& saved_note);

[[nodiscard]] std::optional<Event> leave_screen(const Fonts& fonts, bool session_open);

/// A session that was cut off, as the operator is asked about it.
struct CutOffSession {
    std::string session_id;
    std::string started_utc;
    int answered = 0;
    int count = 0;
    std::string refusal;  ///< why it cannot be continued; empty when it can
};
enum class CutOffChoice { kContinue, kAbandon };
[[nodiscard]] std::optional<CutOffChoice> cut_off_screen(const Fonts& fonts,
                                                         const CutOffSession& session);
/// Asks once more; gives whether to close the session for good.
[[nodiscard]] std::optional<bool> abandon_screen(const Fonts& fonts, const CutOffSession& session);

/// Something could not be saved or read while a participant was at it.
struct Trouble {
    std::string title;
    std::string reason;       ///< small, below all else
    std::string consequence;  ///< what is safe, what to do, and what leaving means
};
/// Gives whether to try again. Only the operator's key leaves, so that no participant gives up an
/// answer.
[[nodiscard]] bool trouble_screen(const Fonts& fonts, const Trouble& trouble);

/// In place of what was hidden, until the screen is as it was; `state` is for the operator.
void hidden_screen(const Fonts& fonts, Sight why, const std::string& state);

/// While the store takes its time.
void saving_screen(const Fonts& fonts);

/// How the operator leaves, on every page that is the operator's too.
inline constexpr const char* kOperatorsKey = "The operator leaves with Ctrl+Shift+Q.";

/// The study's texts on the pages, and what of the pages' own is not plain ASCII, for the fonts.
[[nodiscard]] std::vector<std::string> texts_of_pages(const stimuli::Study& study);

}  // namespace obscura::app::kiosk
