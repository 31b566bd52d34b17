// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "app/kiosk/pin.h"
#include "app/kiosk/procedure.h"
#include "app/kiosk/text_entry.h"
#include "app/kiosk/window.h"
#include "app/window/fonts.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

using window::Fonts;

// One page a file. Each draws itself with Dear ImGui, in the page's words(), and gives back what
// was pressed, if anything.

[[nodiscard]] std::optional<Event> start_screen(const Fonts& fonts);

enum class Gender { kUnanswered, kFemale, kMale, kOwnWords, kRatherNotSay };

/// Of the gender in own words, in characters.
inline constexpr std::size_t kLongestOwnWords = 100;

/// A field of the study's form as it is being filled in.
struct FieldDraft {
    TextEntry entry{stimuli::kLongestFieldText};
    std::string chosen;  ///< empty: nothing
    std::deque<bool> ticked;
    bool to_fill = false;  ///< the keyboard is to go there
};

/// All that is filled in before the instructions, as it stands.
struct FormDraft {
    /// What the keyboard is to fill in next.
    enum class ToFill { kNothing, kAge, kOwnWords, kConsent };

    TextEntry age{3, TextEntry::Takes::kDigits};
    Gender gender = Gender::kUnanswered;
    TextEntry own_words{kLongestOwnWords};
    std::optional<bool> normal_vision;
    std::optional<bool> heard_of_purpose;
    bool consent = false;
    std::vector<FieldDraft> fields;  ///< the study's
    std::deque<bool> agreed;         ///< to the items of the consent
    bool asked_for_consent = false;
    bool submitted = false;  ///< once; from then on complaints are shown
    ToFill to_fill = ToFill::kNothing;
};
[[nodiscard]] Form form_of(const FormDraft& draft, const stimuli::Study& study);
/// `known_codes` are those that a new one may not be.
[[nodiscard]] std::optional<Event> form_screen(const Fonts& fonts, const stimuli::Study& study,
                                               FormDraft& draft,
                                               const std::vector<std::string>& known_codes = {});
/// The study's own questions on that page, and what is filled in.
void draw_fields(const Fonts& fonts, const std::vector<stimuli::FormField>& fields,
                 FormDraft& draft, const std::vector<std::string>& known_codes);
[[nodiscard]] FieldAnswer answer_in(const stimuli::FormField& field, const FieldDraft& draft);

[[nodiscard]] std::optional<Event> information_screen(const Fonts& fonts,
                                                      const stimuli::Study& study);
[[nodiscard]] std::optional<Event> consent_screen(const Fonts& fonts,
                                                  const stimuli::Consent& consent,
                                                  FormDraft& draft);
/// Only the operator goes on with the code, by a key.
[[nodiscard]] std::optional<Event> known_code_screen(const Fonts& fonts, const std::string& code);

[[nodiscard]] std::optional<Event> instructions_screen(const Fonts& fonts,
                                                       const stimuli::Study& study);

/// A list of all pairs, of which the next one's button is enabled, or that button alone.
[[nodiscard]] std::optional<Event> pairs_screen(const Fonts& fonts, const Progress& at,
                                                bool next_button = false);

/// A page of the questions of a pair.
[[nodiscard]] std::optional<Event> question_screen(const Fonts& fonts, const stimuli::Study& study,
                                                   const Progress& at, const AskedPage& page = {});

/// After a pair of practice whose answer was expected.
[[nodiscard]] std::optional<Event> feedback_screen(const Fonts& fonts, bool was_expected);
/// `count` pairs follow.
[[nodiscard]] std::optional<Event> practice_over_screen(const Fonts& fonts, int count);
/// Cannot be left for so many seconds more.
[[nodiscard]] std::optional<Event> break_screen(const Fonts& fonts, const Progress& at,
                                                double left_s);

/// Only the operator leaves it, by a key. `saved_note` says that the answers are saved, and where.
void thanks_screen(const Fonts& fonts, const stimuli::Study& study, const std::string& saved_note);

/// What the operator's page shows and what is filled in there.
struct OperatorView {
    enum class Page { kPin, kOverview, kSessions, kSure };

    Page page = Page::kOverview;
    bool session_open = false;          ///< leaving cuts it off
    std::vector<std::string> lines;     ///< how the study and the machine stand
    std::string note;                   ///< what came of what was pressed last
    std::vector<std::string> sessions;  ///< that can be withdrawn
    std::string chosen;                 ///< of them
    TextEntry pin{kLongestPin, TextEntry::Takes::kHiddenDigits};
    double wait_s = 0.0;  ///< before the next PIN can be tried
};
enum class OperatorAct { kStay, kLeave, kTryPin, kBackUp, kChoose, kAsk, kErase, kBack };
[[nodiscard]] std::optional<OperatorAct> operator_screen(const Fonts& fonts, OperatorView& view);

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

}  // namespace obscura::app::kiosk
