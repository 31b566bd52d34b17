// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace obscura::analysis {

/// What a row is worth: only `participant` rows enter an analysis of participants.
enum class Kind { kParticipant, kPractice, kCatch, kSimulated };

/// Where a session stands. Only a completed one uses up its row of the order.
enum class SessionState { kOpen, kCompleted, kAbandoned };

inline constexpr std::array kKinds{Kind::kParticipant, Kind::kPractice, Kind::kCatch,
                                   Kind::kSimulated};
inline constexpr std::array kSessionStates{SessionState::kOpen, SessionState::kCompleted,
                                           SessionState::kAbandoned};

/// `participant`, `practice`, `catch` or `simulated`, as in the store and in files.
[[nodiscard]] constexpr std::string_view to_string(Kind kind) {
    switch (kind) {
        case Kind::kParticipant:
            return "participant";
        case Kind::kPractice:
            return "practice";
        case Kind::kCatch:
            return "catch";
        case Kind::kSimulated:
            return "simulated";
    }
    return "";
}

/// `open`, `completed` or `abandoned`.
[[nodiscard]] constexpr std::string_view to_string(SessionState state) {
    switch (state) {
        case SessionState::kOpen:
            return "open";
        case SessionState::kCompleted:
            return "completed";
        case SessionState::kAbandoned:
            return "abandoned";
    }
    return "";
}

/// The kind of that name, or nothing.
[[nodiscard]] constexpr std::optional<Kind> kind_from(std::string_view name) {
    for (const Kind kind : kKinds) {
        if (to_string(kind) == name) return kind;
    }
    return std::nullopt;
}

/// The state of that name, or nothing.
[[nodiscard]] constexpr std::optional<SessionState> session_state_from(std::string_view name) {
    for (const SessionState state : kSessionStates) {
        if (to_string(state) == name) return state;
    }
    return std::nullopt;
}

/// Under which a session keeps the hash over all images of its study.
inline constexpr const char* kStimuliDigestEvent = "stimuli digest";

/// Who took part, as the form asks it.
struct ParticipantRecord {
    std::string participant_id;         ///< unique, made by the program
    Kind kind = Kind::kParticipant;     ///< participant or simulated
    std::optional<int> age_years;       ///< 1 to 120
    std::string gender;                 ///< free text, also `rather not say`; empty: no answer
    std::optional<bool> normal_vision;  ///< normal or corrected to normal
    std::optional<bool> naive;          ///< does not know what the study is about
    bool consent = false;
    std::string created_utc;           ///< ISO 8601 with Z
    std::string code = {};             ///< that stands for the participant; empty: none
    std::string consent_version = {};  ///< of the text agreed to; empty: the kiosk's own sentence
    std::string consent_items = {};    ///< that were agreed to, a JSON array; empty: the same
    std::string consent_utc = {};      ///< when; empty: with the form
    /// The study's own questions and the answers: a JSON array of objects with field, kind, label,
    /// unit and value (null: no answer); empty: it has none.
    std::string form = {};

    bool operator==(const ParticipantRecord&) const = default;
};

/// One participant's way through a study, and what it ran on.
struct SessionRecord {
    std::string session_id;  ///< unique, made by the program
    std::string participant_id;
    Kind kind = Kind::kParticipant;
    std::string study;
    std::string study_sha256;
    std::string order;               ///< latin-square, williams, random, fixed
    std::uint64_t seed = 0;          ///< of the study
    std::uint64_t slot = 0;          ///< stimuli::SessionOrder::slot
    std::uint64_t latin_square = 0;  ///< from 0
    int latin_row = 0;               ///< from 0
    bool swapped = false;
    int condition_count = 0;  ///< trials that complete the session, catch and repeats too
    SessionState state = SessionState::kOpen;
    std::string started_utc;
    std::string ended_utc;  ///< empty while open
    std::string software;   ///< name and version
    std::string operating_system;
    std::string gpu_renderer;
    std::string display;      ///< monitor's name, resolution, refresh rate
    double refresh_hz = 0.0;  ///< 0: unknown
    /// The study's rule on whom to leave out: a JSON object with any of min_catch_correct,
    /// min_repeat_agreement (shares, 0 to 1) and min_response_time_s (median, s); empty: no rule.
    std::string exclusion;
    /// What else the study fixed before it had data, its hypotheses: a JSON object as
    /// stimuli::Study::plan_json() writes it; empty: nothing.
    std::string study_plan;
    /// How its times came about: a JSON object with source, frame_ms, waits and self_test; empty:
    /// the session is simulated, or from before this was kept.
    std::string timing = {};
    /// 0: begun in this store; else the session was merged into it, and so many others hold its
    /// slot too.
    int slot_copy = 0;

    bool operator==(const SessionRecord&) const = default;
};

/// One answer, with all that was shown and when. Times come from one monotonic clock.
struct TrialRecord {
    std::string session_id;
    Kind kind = Kind::kParticipant;
    int trial_index = 0;  ///< from 0, in order of showing
    std::string condition;
    std::string hypothesis;
    std::string scene;
    std::string validity;
    std::string condition_A;  ///< variant name of side A, e.g. Crytek24
    std::string condition_B;
    char first_shown = 'A';        ///< 'A' or 'B'
    bool response_first = false;   ///< the image shown first was chosen
    bool is_A_selected = false;    ///< follows from the two above; the store checks it
    double response_time_s = 0.0;  ///< question onset to answer
    double first_onset_s = 0.0;    ///< since the session began
    double second_onset_s = 0.0;
    double question_onset_s = 0.0;
    double first_view_ms = 0.0;
    double second_view_ms = 0.0;
    double grey_ms_measured = 0.0;
    int dropped_frames = 0;
    /// From the first image's onset to the answer: how long the screen was not to be seen whole and
    /// in front, or the operator's question covered it. Nothing: answered before this was measured.
    std::optional<double> hidden_ms;
    std::string first_sha256;  ///< of the PNG shown first
    std::string second_sha256;
    std::string answered_utc;
    char expected =
        '\0';  ///< 'A' or 'B': what an attentive observer picks, of a catch trial; else 0
    /// Why the operator went on where the start refused; empty: it did not refuse.
    std::string override_reason = {};
    std::string repeats;  ///< condition whose answer this one repeats, no vote then; empty: none

    bool operator==(const TrialRecord&) const = default;
};

/// Anything else worth knowing about a session: started, resumed, left by the operator ...
struct EventRecord {
    std::string session_id;  ///< empty: not of a session
    std::string time_utc;
    std::string name;
    std::string detail;

    bool operator==(const EventRecord&) const = default;
};

}  // namespace obscura::analysis
