// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/tables.h"

#include "analysis/export/events.h"
#include "analysis/export/member_cells.h"
#include "analysis/export/screen_columns.h"
#include "analysis/export/table_words.h"

namespace obscura::analysis {

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
                {"timing", kTiming, {}, "", of_own_session<&R::timing>},
            }};
        for (const auto& more : {screen_columns(), event_count_columns()}) {
            sessions.columns.insert(sessions.columns.end(), more.begin(), more.end());
        }
        return sessions;
    }();
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
            {"role",
             "Whether the test is one of the family that Holm's correction is over",
             {{"primary", "it is"}, {"secondary", "it stands alone, uncorrected"}},
             "",
             of<&R::role>},
            {"question",
             "What is asked of the votes, of each participant's answers together",
             {{"preference", "is B chosen more often than A? Signs of the differences are flipped"},
              {"interaction",
               "does the preference differ between two levels, of participants who answered all "
               "of the conditions? Signs of the differences are flipped; of one condition a level "
               "that is McNemar's exact test"},
              {"levels",
               "does it differ between several levels, of participants who answered all of the "
               "conditions? Cochran's Q"},
              {"none",
               "a test of the family that these tables cannot repeat: nobody answered what it "
               "compares, its conditions are not the same question, or its differences are not "
               "whole. In the correction it counts as p = 1"}},
             "",
             of<&R::question>},
            {"condition",
             "Name of the condition; empty where the question is none",
             {},
             "",
             of<&R::condition>},
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
