// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/tables.h"

#include "analysis/export/events.h"
#include "analysis/export/member_cells.h"

namespace obscura::analysis {
namespace {

using Levels = std::vector<std::pair<std::string, std::string>>;

const Levels kYesNo{{"1", "yes"}, {"0", "no"}};
const Levels kSubjectKinds{{"participant", "a person took part"},
                           {"simulated", "answers made by a simulated observer, not a person"}};
const Levels kTrialKinds{{"participant", "an answer of a person that counts"},
                         {"practice", "a practice trial, never analysed"},
                         {"catch", "an attention check, never a vote"},
                         {"simulated", "an answer made by a simulated observer, not a person"}};
const Levels kStates{{"open", "running, or cut off"},
                     {"completed", "all conditions answered; only these are analysed"},
                     {"abandoned", "broken off"}};
const Levels kValidities{{"low", "constant ambient light only"},
                         {"moderate", "irradiance from an environment map"},
                         {"high", "irradiance and a directional light with shadows"}};
const Levels kSides{{"A", "variant A of the condition"}, {"B", "variant B of the condition"}};

constexpr const char* kUtc = "Time in UTC, ISO 8601";
constexpr const char* kSha256 = "SHA-256 of the image file, 64 hexadecimal digits";
constexpr const char* kSeed = "Seed of the study, from which the order was drawn";
constexpr const char* kSwapped =
    "Whether variant B was shown first in every pair of the session; where the study balances the "
    "sides within a session, in the pairs of every other condition only: first_shown of a trial "
    "says it";
constexpr const char* kSquare = "Number of the square that gave the order, from 0";
constexpr const char* kRow = "Row of that square, from 0";
constexpr const char* kExclusion =
    "The study file's rule on whom to leave out, as JSON: smallest share of catch trials answered "
    "as expected, of repeated pairs answered alike, smallest median response time in seconds; "
    "empty: no rule";
constexpr const char* kStudyPlan =
    "What the study file fixed before there were data, as JSON: the hypotheses with the conditions "
    "that they take; empty: nothing";
constexpr const char* kExpected =
    "Variant that an attentive observer picks; empty: no attention check";
constexpr const char* kRepeats =
    "Condition whose answer this one repeats, which is then no vote; empty: none";
constexpr const char* kVariant =
    "Technique and samples, with what differs where two would have one name, of variant ";

bool is_vote(const TrialRow& row) {
    return row.session->state == SessionState::kCompleted && row.trial->kind == row.session->kind &&
           row.trial->repeats.empty();
}

}  // namespace

const ExportTable<ParticipantRecord>& participants_export() {
    using R = ParticipantRecord;
    static const ExportTable<R> table{
        "participants",
        {
            {"participant_id",
             "Name of the participant, made by the program",
             {},
             "",
             of<&R::participant_id>},
            {"kind", "Who answered", kSubjectKinds, "", of<&R::kind>},
            {"age_years",
             "Age as given in the form; empty: not said",
             {},
             "years",
             of<&R::age_years>,
             true},
            {"gender",
             "Gender: female, male, rather not say, or the participant's own words; empty: no "
             "answer",
             {},
             "",
             of<&R::gender>,
             true},
            {"normal_vision", "Normal or corrected-to-normal vision; empty: not said", kYesNo, "",
             of<&R::normal_vision>},
            {"naive", "Naive to the purpose of the study; empty: not said", kYesNo, "",
             of<&R::naive>},
            {"consent", "Consent to take part", kYesNo, "", of<&R::consent>},
            {"code",
             "Code that stands for the participant, typed or made by the kiosk; empty: none",
             {},
             "",
             of<&R::code>,
             true},
            {"consent_version",
             "Version of the text that was agreed to; empty: the kiosk's own sentence",
             {},
             "",
             of<&R::consent_version>},
            {"consent_items",
             "Sentences that were agreed to, one by one, as JSON; empty: the kiosk's own",
             {},
             "",
             of<&R::consent_items>},
            {"consent_utc",
             std::string(kUtc) + ", when it was agreed to; empty: with the form",
             {},
             "",
             of<&R::consent_utc>,
             true},
            {"created_utc",
             std::string(kUtc) + ", when the form was sent",
             {},
             "",
             of<&R::created_utc>,
             true},
        }};
    return table;
}

const ExportTable<SessionRow>& sessions_export() {
    using R = SessionRecord;
    static const ExportTable<SessionRow> table = [] {
        ExportTable<SessionRow> sessions{
            "sessions",
            {
                {"session_id",
                 "Name of the session, made by the program",
                 {},
                 "",
                 of_own_session<&R::session_id>},
                {"participant_id",
                 "Participant, as in the table participants",
                 {},
                 "",
                 of_own_session<&R::participant_id>},
                {"kind", "Who answered", kSubjectKinds, "", of_own_session<&R::kind>},
                {"study", "Name of the study", {}, "", of_own_session<&R::study>},
                {"study_sha256",
                 "SHA-256 of the study file",
                 {},
                 "",
                 of_own_session<&R::study_sha256>},
                {"order",
                 "How conditions are ordered over participants",
                 {{"latin-square", "random Latin squares"},
                  {"williams", "Williams designs"},
                  {"random", "a random permutation for each participant"},
                  {"fixed", "the order of the study file"}},
                 "",
                 of_own_session<&R::order>},
                {"seed", kSeed, {}, "", of_own_session<&R::seed>},
                {"slot",
                 "Place in the sequence of orders, from 0",
                 {},
                 "",
                 of_own_session<&R::slot>,
                 true},
                {"latin_square", kSquare, {}, "", of_own_session<&R::latin_square>},
                {"latin_row", kRow, {}, "", of_own_session<&R::latin_row>},
                {"swapped", kSwapped, kYesNo, "", of_own_session<&R::swapped>},
                {"condition_count",
                 "Answers that complete the session",
                 {},
                 "",
                 of_own_session<&R::condition_count>},
                {"state", "How the session ended", kStates, "", of_own_session<&R::state>},
                {"started_utc",
                 std::string(kUtc) + ", start",
                 {},
                 "",
                 of_own_session<&R::started_utc>,
                 true},
                {"ended_utc",
                 std::string(kUtc) + ", end; empty while open",
                 {},
                 "",
                 of_own_session<&R::ended_utc>,
                 true},
                {"software",
                 "Name and version of the program",
                 {},
                 "",
                 of_own_session<&R::software>},
                {"operating_system",
                 "Operating system",
                 {},
                 "",
                 of_own_session<&R::operating_system>},
                {"gpu_renderer",
                 "Renderer string of the OpenGL driver",
                 {},
                 "",
                 of_own_session<&R::gpu_renderer>},
                {"display",
                 "Monitor, its resolution and refresh rate",
                 {},
                 "",
                 of_own_session<&R::display>},
                {"refresh_hz",
                 "Refresh rate of the monitor; 0: not known",
                 {},
                 "Hz",
                 of_own_session<&R::refresh_hz>},
                {"exclusion", kExclusion, {}, "", of_own_session<&R::exclusion>},
                {"study_plan", kStudyPlan, {}, "", of_own_session<&R::study_plan>},
            }};
        const auto counts = event_count_columns();
        sessions.columns.insert(sessions.columns.end(), counts.begin(), counts.end());
        return sessions;
    }();
    return table;
}

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

const ExportTable<ConditionRow>& conditions_export() {
    using R = ConditionRow;
    using T = TrialRecord;
    static const ExportTable<R> table{
        "conditions",
        {
            {"study", "Name of the study", {}, "", of<&R::study>},
            {"condition", "Name of the condition", {}, "", of_shown<&T::condition>},
            {"hypothesis",
             "Hypothesis that the condition serves; may be empty",
             {},
             "",
             of_shown<&T::hypothesis>},
            {"scene", "Scene shown", {}, "", of_shown<&T::scene>},
            {"validity", "Ecological validity of the scene's lighting", kValidities, "",
             of_shown<&T::validity>},
            {"condition_A", kVariant + std::string("A"), {}, "", of_shown<&T::condition_A>},
            {"condition_B", kVariant + std::string("B"), {}, "", of_shown<&T::condition_B>},
            {"expected", kExpected, kSides, "", of_shown<&T::expected>},
            {"repeats", kRepeats, {}, "", of_shown<&T::repeats>},
            {"kind", "What the answers are worth", kTrialKinds, "", of<&R::kind>},
            {"count_A",
             "Votes for variant A in completed sessions",
             {},
             "votes",
             {[](const R& row, std::string& out) { append_cell(out, row.votes.a); }, true}},
            {"count_B",
             "Votes for variant B in completed sessions",
             {},
             "votes",
             {[](const R& row, std::string& out) { append_cell(out, row.votes.b); }, true}},
        }};
    return table;
}

const ExportTable<ExportedTest>& tests_export() {
    using R = ExportedTest;
    static const ExportTable<R> table{
        "tests",
        {
            {"study", "Name of the study", {}, "", of<&R::study>},
            {"kind", "Who answered", kSubjectKinds, "", of<&R::kind>},
            {"test", "What is tested; the test's conditions are its rows", {}, "", of<&R::test>},
            {"question",
             "What is asked of the votes, of each participant's answers together",
             {{"preference", "is B chosen more often than A? Signs of the differences are flipped"},
              {"interaction",
               "does the preference differ between two levels, of participants who answered all "
               "of the conditions? Signs of the differences are flipped; of one condition a level "
               "that is McNemar's exact test"},
              {"levels",
               "does it differ between several levels, of participants who answered all of the "
               "conditions? Cochran's Q"}},
             "",
             of<&R::question>},
            {"condition", "Name of the condition", {}, "", of<&R::condition>},
            {"level", "Ecological validity of the condition's lighting; empty: not said",
             kValidities, "", of<&R::level>},
            {"weight",
             "A participant's difference is the sum of weight * (+1 for an answer B, -1 for A); "
             "empty: the test has none",
             {},
             "",
             of<&R::weight>},
        }};
    return table;
}

}  // namespace obscura::analysis
