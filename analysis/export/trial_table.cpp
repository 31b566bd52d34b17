// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/tables.h"

#include "analysis/export/events.h"
#include "analysis/export/member_cells.h"
#include "analysis/export/table_words.h"

namespace obscura::analysis {
namespace {

bool is_vote(const TrialRow& row) {
    return row.session->state == SessionState::kCompleted && row.trial->kind == row.session->kind &&
           row.trial->repeats.empty();
}

}  // namespace

const ExportTable<TrialRow>& trials_export() {
    using T = TrialRecord;
    using S = SessionRecord;
    static const ExportTable<TrialRow> table{
        "trials",
        {
            {"participant_id",
             "Participant, as in the table participants",
             {},
             "",
             of_session<&S::participant_id>},
            {"session_id", "Session, as in the table sessions", {}, "", of_trial<&T::session_id>},
            {"trial_index",
             "Place of the trial in the session, from 0",
             {},
             "",
             of_trial<&T::trial_index>},
            {"condition", "Name of the condition", {}, "", of_trial<&T::condition>},
            {"scene", "Scene shown", {}, "", of_trial<&T::scene>},
            {"validity", "Ecological validity of the scene's lighting", kValidities, "",
             of_trial<&T::validity>},
            {"condition_A", kVariant + std::string("A"), {}, "", of_trial<&T::condition_A>},
            {"condition_B", kVariant + std::string("B"), {}, "", of_trial<&T::condition_B>},
            {"is_A_selected", "Whether variant A was chosen", kYesNo, "",
             of_trial<&T::is_A_selected>},
            {"first_shown", "Which variant was shown first", kSides, "", of_trial<&T::first_shown>},
            {"response",
             "Which image was chosen, by the order of showing",
             {{"first", "the image shown first"}, {"second", "the image shown second"}},
             "",
             {[](const TrialRow& row, std::string& out) {
                  out += row.trial->response_first ? "first" : "second";
              },
              false}},
            {"response_time_s",
             "From the question's appearance to the answer",
             {},
             "s",
             of_trial<&T::response_time_s>},
            {"grey_ms_measured",
             "Duration of the grey interval between the images, measured",
             {},
             "ms",
             of_trial<&T::grey_ms_measured>},
            {"first_view_ms",
             "How long the first image was seen",
             {},
             "ms",
             of_trial<&T::first_view_ms>},
            {"second_view_ms",
             "How long the second image was seen",
             {},
             "ms",
             of_trial<&T::second_view_ms>},
            {"first_sha256",
             std::string(kSha256) + ", shown first",
             {},
             "",
             of_trial<&T::first_sha256>},
            {"second_sha256",
             std::string(kSha256) + ", shown second",
             {},
             "",
             of_trial<&T::second_sha256>},
            {"latin_square", kSquare, {}, "", of_session<&S::latin_square>},
            {"latin_row", kRow, {}, "", of_session<&S::latin_row>},
            {"swapped", kSwapped, kYesNo, "", of_session<&S::swapped>},
            {"seed", kSeed, {}, "", of_session<&S::seed>},
            {"kind", "What the answer is worth", kTrialKinds, "", of_trial<&T::kind>},
            {"study", "Name of the study", {}, "", of_session<&S::study>},
            {"hypothesis",
             "Hypothesis that the condition serves; may be empty",
             {},
             "",
             of_trial<&T::hypothesis>},
            {"session_state", "How the session ended", kStates, "", of_session<&S::state>},
            {"first_onset_s",
             "Onset of the first image since the session began",
             {},
             "s",
             of_trial<&T::first_onset_s>},
            {"second_onset_s",
             "Onset of the second image since the session began",
             {},
             "s",
             of_trial<&T::second_onset_s>},
            {"question_onset_s",
             "Onset of the question since the session began",
             {},
             "s",
             of_trial<&T::question_onset_s>},
            {"dropped_frames",
             "Frames that the display missed during the trial",
             {},
             "",
             of_trial<&T::dropped_frames>},
            {"hidden_ms",
             "How long, from the first image's onset to the answer, the screen was not to be seen "
             "whole and in front (focus lost, iconified, covered, resized, monitor off) or covered "
             "by the operator's question; no part of the times seen or of the response time; "
             "empty: not measured",
             {},
             "ms",
             of_trial<&T::hidden_ms>},
            {"answered_utc",
             std::string(kUtc) + ", of the answer",
             {},
             "",
             of_trial<&T::answered_utc>,
             true},
            {"expected", kExpected, kSides, "", of_trial<&T::expected>},
            {"repeats", kRepeats, {}, "", of_trial<&T::repeats>},
            {"override_reason",
             "Why the operator went on where the kiosk's start refused; empty: it did not refuse",
             {},
             "",
             of_trial<&T::override_reason>},
            {"exclusion", kExclusion, {}, "", of_session<&S::exclusion>},
            {"study_plan", kStudyPlan, {}, "", of_session<&S::study_plan>},
            {"study_A",
             "Which of the two variants the study calls A",
             {},
             "",
             of_trial<&T::condition_A>},
            {"chose_B",
             "Whether variant B was chosen",
             kYesNo,
             "",
             {[](const TrialRow& row, std::string& out) {
                  append_cell(out, !row.trial->is_A_selected);
              },
              true}},
            {"is_vote",
             "Whether the answer is a vote: of a completed session, and no practice, catch or "
             "repeated trial. The analysis is of votes with excluded 0",
             kYesNo,
             "",
             {[](const TrialRow& row, std::string& out) { append_cell(out, is_vote(row)); }, true}},
            {"excluded",
             "Whether the study's rule leaves the participant out of the analysis; empty: not "
             "decided, as for a session that was not completed",
             kYesNo,
             "",
             {[](const TrialRow& row, std::string& out) {
                  if (row.left_out != nullptr) append_cell(out, !row.left_out->empty());
              },
              true}},
            {"excluded_reason",
             "Why the rule leaves the participant out; empty: it does not",
             {},
             "",
             {[](const TrialRow& row, std::string& out) {
                  if (row.left_out != nullptr) out += *row.left_out;
              },
              false}},
            {"scene_source",
             "Built-in scene or file that was shown; two scenes of one source and camera differ in "
             "their light only; empty: not known",
             {},
             "",
             {[](const TrialRow& row, std::string& out) {
                  if (row.view != nullptr) out += row.view->scene_source;
              },
              false}},
            {"camera",
             "Camera of that scene, by its name; study: one that the study file describes; empty: "
             "not known",
             {},
             "",
             {[](const TrialRow& row, std::string& out) {
                  if (row.view != nullptr) out += row.view->camera;
              },
              false}},
        }};
    return table;
}

}  // namespace obscura::analysis
