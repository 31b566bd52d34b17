// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/checks.h"

#include <cctype>
#include <limits>
#include <nlohmann/json.hpp>

#include "analysis/text/text.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

constexpr double kMaxSeconds = 1e9;
constexpr double kMaxMilliseconds = 1e12;
constexpr double kMaxRefreshHz = 1e6;
/// Databases have signed 64-bit integers.
constexpr std::uint64_t kMaxInteger = std::numeric_limits<std::int64_t>::max();
constexpr int kMaxInt = std::numeric_limits<int>::max();

void check_text(const std::string& where, const char* name, const std::string& value) {
    if (value.find('\0') != std::string::npos) {
        throw base::bad_input("{}: {} holds a NUL character, which is not allowed", where, name);
    }
    if (!is_utf8(value)) throw base::bad_input("{}: {} is not UTF-8 text", where, name);
}

void check_word(const std::string& where, const char* name, const std::string& value) {
    check_text(where, name, value);
    if (value.empty()) throw base::bad_input("{}: {} is empty", where, name);
}

void check_subject_kind(const std::string& where, Kind kind) {
    if (kind != Kind::kParticipant && kind != Kind::kSimulated) {
        throw base::bad_input("{}: kind is {}, allowed is participant or simulated", where,
                              to_string(kind));
    }
}

void check_array(const std::string& where, const char* column, const std::string& text) {
    check_text(where, column, text);
    if (!text.empty() && !nlohmann::json::parse(text, nullptr, false).is_array()) {
        throw base::bad_input("{}: {} is '{}', allowed is a JSON array or nothing", where, column,
                              text);
    }
}

void check_object(const std::string& where, const char* column, const std::string& text) {
    check_text(where, column, text);
    if (!text.empty() && !nlohmann::json::parse(text, nullptr, false).is_object()) {
        throw base::bad_input("{}: {} is '{}', allowed is a JSON object or nothing", where, column,
                              text);
    }
}

/// A catch trial expects an answer; a vote may repeat another condition's.
void check_attention(const std::string& where, const TrialRecord& trial) {
    const bool is_catch = trial.kind == Kind::kCatch;
    const bool is_side = trial.expected == 'A' || trial.expected == 'B';
    if (is_catch ? !is_side : trial.expected != '\0') {
        throw base::bad_input("{}: expected is code {}, allowed for kind {} is {}", where,
                              static_cast<int>(trial.expected), to_string(trial.kind),
                              is_catch ? "A or B" : "nothing");
    }
    check_text(where, "repeats", trial.repeats);
    if (trial.repeats.empty()) return;
    if (trial.repeats == trial.condition) {
        throw base::bad_input("{}: repeats is '{}', the trial's own condition", where,
                              trial.repeats);
    }
    if (is_catch || trial.kind == Kind::kPractice) {
        throw base::bad_input("{}: repeats is '{}', allowed for kind {} is nothing", where,
                              trial.repeats, to_string(trial.kind));
    }
}

}  // namespace

void check_utc(const std::string& where, const char* name, const std::string& value) {
    check_text(where, name, value);
    constexpr std::string_view kForm = "dddd-dd-ddTdd:dd:dd";
    bool good = value.size() > kForm.size() && value.back() == 'Z';
    for (std::size_t at = 0; good && at < kForm.size(); ++at) {
        good = kForm[at] == 'd' ? std::isdigit(static_cast<unsigned char>(value[at])) != 0
                                : value[at] == kForm[at];
    }
    if (!good) {
        throw base::bad_input("{}: {} is '{}', allowed is UTC as 2010-05-01T12:00:00Z", where, name,
                              value);
    }
}

void check(const ParticipantRecord& participant) {
    check_word("participant", "participant_id", participant.participant_id);
    const std::string where = "participant " + participant.participant_id;
    check_subject_kind(where, participant.kind);
    if (participant.age_years)
        base::check_range(where, "age_years", *participant.age_years, 1, 120);
    check_text(where, "gender", participant.gender);
    check_utc(where, "created_utc", participant.created_utc);
    check_text(where, "code", participant.code);
    check_text(where, "consent_version", participant.consent_version);
    check_array(where, "consent_items", participant.consent_items);
    if (!participant.consent_utc.empty()) {
        check_utc(where, "consent_utc", participant.consent_utc);
    }
    check_array(where, "form", participant.form);
}

void check(const SessionRecord& session) {
    check_word("session", "session_id", session.session_id);
    const std::string where = "session " + session.session_id;
    check_word(where, "participant_id", session.participant_id);
    check_subject_kind(where, session.kind);
    check_word(where, "study", session.study);
    check_text(where, "study_sha256", session.study_sha256);
    check_word(where, "order", session.order);
    base::check_range(where, "seed", session.seed, std::uint64_t{0}, kMaxInteger);
    base::check_range(where, "slot", session.slot, std::uint64_t{0}, kMaxInteger);
    base::check_range(where, "latin_square", session.latin_square, std::uint64_t{0}, kMaxInteger);
    base::check_range(where, "latin_row", session.latin_row, 0, kMaxInt);
    base::check_range(where, "condition_count", session.condition_count, 1, kMaxInt);
    if (session.state != SessionState::kOpen || !session.ended_utc.empty()) {
        throw base::bad_input("{}: begins as {} with the end '{}', allowed is open without an end",
                              where, to_string(session.state), session.ended_utc);
    }
    check_utc(where, "started_utc", session.started_utc);
    check_text(where, "software", session.software);
    check_text(where, "operating_system", session.operating_system);
    check_text(where, "gpu_renderer", session.gpu_renderer);
    check_text(where, "display", session.display);
    base::check_range(where, "refresh_hz", session.refresh_hz, 0.0, kMaxRefreshHz);
    check_object(where, "exclusion", session.exclusion);
    check_object(where, "study_plan", session.study_plan);
    check_object(where, "timing", session.timing);
}

void check(const TrialRecord& trial) {
    check_word("trial", "session_id", trial.session_id);
    const std::string where =
        "trial " + std::to_string(trial.trial_index) + " of session " + trial.session_id;
    base::check_range(where, "trial_index", trial.trial_index, 0, kMaxInt);
    check_word(where, "condition", trial.condition);
    check_text(where, "hypothesis", trial.hypothesis);
    check_text(where, "scene", trial.scene);
    if (trial.validity != "low" && trial.validity != "moderate" && trial.validity != "high") {
        throw base::bad_input("{}: validity is '{}', allowed is low, moderate or high", where,
                              trial.validity);
    }
    check_word(where, "condition_A", trial.condition_A);
    check_word(where, "condition_B", trial.condition_B);
    if (trial.first_shown != 'A' && trial.first_shown != 'B') {
        throw base::bad_input("{}: first_shown is code {}, allowed is A or B", where,
                              static_cast<int>(trial.first_shown));
    }
    const bool first_is_A = trial.first_shown == 'A';
    if (trial.is_A_selected != (trial.response_first == first_is_A)) {
        throw base::bad_input(
            "{}: is_A_selected is {}, but {} was shown first and the image shown {} was chosen",
            where, trial.is_A_selected, trial.first_shown,
            trial.response_first ? "first" : "second");
    }
    base::check_range(where, "response_time_s", trial.response_time_s, 0.0, kMaxSeconds);
    base::check_range(where, "first_onset_s", trial.first_onset_s, 0.0, kMaxSeconds);
    base::check_range(where, "second_onset_s", trial.second_onset_s, 0.0, kMaxSeconds);
    base::check_range(where, "question_onset_s", trial.question_onset_s, 0.0, kMaxSeconds);
    base::check_range(where, "first_view_ms", trial.first_view_ms, 0.0, kMaxMilliseconds);
    base::check_range(where, "second_view_ms", trial.second_view_ms, 0.0, kMaxMilliseconds);
    base::check_range(where, "grey_ms_measured", trial.grey_ms_measured, 0.0, kMaxMilliseconds);
    base::check_range(where, "dropped_frames", trial.dropped_frames, 0, kMaxInt);
    if (trial.hidden_ms) {
        base::check_range(where, "hidden_ms", *trial.hidden_ms, 0.0, kMaxMilliseconds);
    }
    check_text(where, "first_sha256", trial.first_sha256);
    check_text(where, "second_sha256", trial.second_sha256);
    check_utc(where, "answered_utc", trial.answered_utc);
    check_text(where, "override_reason", trial.override_reason);
    check_attention(where, trial);
}

void check(const EventRecord& event) {
    check_word("event", "name", event.name);
    const std::string where = "event '" + event.name + "'";
    check_text(where, "session_id", event.session_id);
    check_utc(where, "time_utc", event.time_utc);
    check_text(where, "detail", event.detail);
}

}  // namespace obscura::analysis
