// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>

#include "analysis/conclusions/analysis.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/text_report.h"
#include "renderer/base/error.h"
#include "tests/analysis/records_for_test.h"
#include "tests/analysis/trials_text.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kHeader = "observer,condition_A,condition_B,is_A_selected\n";

Tally tally(const std::string& text) {
    return tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant);
}

std::string refusal_of(const std::string& text) {
    try {
        (void)tally(text);
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        return error.what();
    }
    return "accepted";
}

TEST(TrialsFile, CountsChoicesWhicheverVariantIsCalledA) {
    const Tally votes = tally(kHeader +
                              "ann,None,Crytek24,0\n"
                              "bob,Crytek24,None,1\n"
                              "cleo,None,Crytek24,true\n"
                              "cleo,Blizzard24,None,false\n");
    EXPECT_EQ(*votes.n_participants, 3);
    ASSERT_EQ(votes.conditions.size(), 2U);
    EXPECT_EQ(votes.conditions[1].id, "None - Crytek24");
    EXPECT_EQ(votes.conditions[1].variant_a, "None");
    EXPECT_EQ(votes.conditions[1].votes.a, 1);
    EXPECT_EQ(votes.conditions[1].votes.b, 2);
    EXPECT_EQ(votes.conditions[0].id, "None - Blizzard24");
    EXPECT_EQ(votes.conditions[0].votes.a, 1);
    EXPECT_EQ(votes.conditions[0].votes.b, 0);
    EXPECT_EQ(votes.order.reason, "the file does not say which image was shown first");
}

TEST(TrialsFile, ReadsAnyLineEndsAMarkAndColumnsInAnyOrder) {
    const std::string rows =
        "is_A_selected,scene,observer,condition_B,condition_A\n"
        "1,hall,ann,x,y\n"
        "0,yard,ann,x,y\n";
    std::string crlf;
    for (const char letter : rows)
        crlf += letter == '\n' ? std::string("\r\n") : std::string{letter};
    for (const std::string& text : {rows, crlf, "\xEF\xBB\xBF" + rows, "\xEF\xBB\xBF" + crlf,
                                    rows.substr(0, rows.size() - 1)}) {
        const Tally votes = tally(text);
        ASSERT_EQ(votes.conditions.size(), 2U);
        EXPECT_EQ(votes.conditions[0].id, "hall: x - y");
        EXPECT_EQ(votes.conditions[0].votes.b, 1);
        EXPECT_EQ(votes.conditions[1].votes.a, 1);
    }
}

TEST(TrialsFile, OrderSaysWhatWasShownFirst) {
    const std::string header = "observer,condition_A,condition_B,is_A_selected,order\n";
    // Second chosen: rows 1 and 3; the third row has the variants the other way round.
    const Tally votes = tally(header + "ann,x,y,0,AB\nbob,x,y,0,BA\ncleo,y,x,1,BA\ndan,x,y,1,A\n");
    EXPECT_EQ(votes.order->n, 4);
    EXPECT_EQ(votes.order->second_chosen, 2);
    EXPECT_EQ(votes.conditions[0].answers[2].chose_b, true);
    EXPECT_EQ(votes.conditions[0].answers[2].b_second, true);
    const Tally numbered = tally(header + "ann,x,y,0,1\nann,x,z,0,2\n");
    EXPECT_THAT(numbered.order.reason, HasSubstr("numbers the trials"));
    EXPECT_THAT(refusal_of(header + "ann,x,y,0,AB\nbob,x,y,0,2\ncleo,x,y,0,left\n"),
                AllOf(HasSubstr("t.csv:3: column order: '2'"),
                      HasSubstr("t.csv:4: column order: 'left', allowed are AB, BA, A, B")));
}

TEST(TrialsFile, SessionsOfDifferentObserversMayShareAName) {
    const Tally votes = tally(
        "observer,session_id,condition_A,condition_B,is_A_selected\n"
        "ann,1,x,y,0\nbob,1,x,y,1\nann,2,x,y,1\n");
    EXPECT_EQ(*votes.n_participants, 2);
    EXPECT_EQ(votes.conditions[0].votes.n(), 3);
    // Answers stand by participant, whatever the order of rows.
    EXPECT_EQ(votes.conditions[0].answers[0].participant,
              votes.conditions[0].answers[1].participant);
}

TEST(TrialsFile, SaysEverythingThatIsWrongWithItsPlace) {
    EXPECT_THAT(
        refusal_of("observer,condition_A,condition_B,is_A_selected,scene\n"
                   "ann,x,y,2,hall\n"
                   ",x,y,1,hall\n"
                   "bob,x,y,1\n"
                   "bob,x,x,1,hall\n"
                   "bob,x,,1,hall\n"),
        AllOf(HasSubstr("t.csv:2: column is_A_selected: '2', allowed are 0, 1, true, false"),
              HasSubstr("t.csv:3: column observer is empty"),
              HasSubstr("t.csv:4: the row has 4 fields, the header has 5"),
              HasSubstr("t.csv:5: column condition_B: 'x', allowed is another variant"),
              HasSubstr("t.csv:6: column condition_B is empty")));
    EXPECT_THAT(refusal_of(""), HasSubstr("the file is empty"));
    EXPECT_THAT(refusal_of(kHeader), HasSubstr("t.csv:1: there is no row below the header"));
    EXPECT_THAT(refusal_of(kHeader + "ann,x,\"y,1\n"),
                HasSubstr("t.csv:2: column 3: '\"y': a quote"));
    EXPECT_THAT(refusal_of(kHeader + "ann,x,\"y\x1b\n\",1\nann,\"x\r\",y\x07z,maybe\n"),
                AllOf(HasSubstr("y\\x1b"), HasSubstr("y\\x07z"), HasSubstr("control characters"),
                      Not(HasSubstr("\x1b")), Not(HasSubstr("\x07")), Not(HasSubstr("\r"))));
    std::string many = kHeader;
    for (int i = 0; i < 250; ++i) many += "ann,x,y,perhaps\n";
    EXPECT_EQ(
        refusal_of(many),
        "t.csv:2: column is_A_selected: 'perhaps', allowed are 0, 1, true, false and the like "
        "(249 lines more, the last is 251)")
        << "one message a problem";
    many = kHeader;
    for (int i = 0; i < 250; ++i) many += fmt::format("ann,x,y,{}\n", i + 2);
    EXPECT_THAT(refusal_of(many), AllOf(HasSubstr("t.csv:101: "), Not(HasSubstr("t.csv:102: ")),
                                        HasSubstr("and 150 more like these")));
}

TEST(TrialsFile, FindsDuplicatesAndContradictions) {
    const std::string header =
        "observer,session_id,trial_index,condition,condition_A,condition_B,first_shown,"
        "is_A_selected,response,kind,session_state\n";
    EXPECT_EQ(refusal_of(header + "a,s,0,I,x,y,A,1,first,participant,completed\n"), "accepted");
    EXPECT_THAT(refusal_of(header + "a,s,0,I,x,y,A,1,first,participant,completed\n"
                                    "a,s,0,II,x,z,A,0,first,participant,completed\n"
                                    "a,s,1,I,x,z,C,0,first,simulated,open\n"
                                    "b,s,x,I,x,z,A,0,third,robot,completed\n"),
                AllOf(HasSubstr("t.csv:3: column trial_index: '0', allowed is each number once in "
                                "a session, this one is in line 2"),
                      HasSubstr("t.csv:3: column response: 'first', allowed is what"),
                      HasSubstr("t.csv:4: column first_shown: 'C'"),
                      HasSubstr("t.csv:4: column kind: 'simulated', allowed is participant"),
                      HasSubstr("t.csv:4: column session_state: 'open'"),
                      HasSubstr("t.csv:5: column trial_index: 'x'"),
                      HasSubstr("t.csv:5: column response: 'third'"),
                      HasSubstr("t.csv:5: column kind: 'robot'"),
                      HasSubstr("t.csv:5: condition 'I' is x against z")));
}

TEST(TrialsFile, OneParticipantAndAnswersAllAlikeHaveAnAnalysis) {
    const std::string text = text_report(analyse(tally(kHeader + "ann,x,y,1\nann,z,y,1\n")));
    EXPECT_THAT(text,
                AllOf(HasSubstr("1 participant,"), Not(HasSubstr("nan")), HasSubstr("separated")));
}

/// Sessions of all kinds and states with random answers; one participant comes back if `repeats`.
StoreContents random_contents(bool repeats) {
    std::mt19937 random(20100501);
    std::bernoulli_distribution coin(.6);
    StoreContents contents;
    constexpr std::array<const char*, 3> levels{"low", "moderate", "high"};
    for (int number = 0; number < 40; ++number) {
        SessionRecord session = tests::a_session(number);
        session.kind = number % 5 == 4 ? Kind::kSimulated : Kind::kParticipant;
        session.state = number % 7 == 6 ? SessionState::kAbandoned : SessionState::kCompleted;
        if (number == 11 && repeats) session.participant_id = "p10";
        for (int index = 0; index < 7; ++index) {
            TrialRecord trial = tests::a_trial(number, index);
            trial.kind = index == 6 && number == 0 ? Kind::kPractice
                         : index == 5              ? Kind::kCatch
                                                   : session.kind;
            if (index == 5) trial.expected = 'A';
            if (index == 4) trial.repeats = "C3";
            trial.validity = levels.at(static_cast<std::size_t>(index % 3));
            trial.hypothesis = index < 3 ? "H1" : "H2";
            trial.condition_A = index < 3 ? "None" : "Crytek, \"24\"";
            trial.first_shown = coin(random) ? 'A' : 'B';
            trial.response_first = coin(random);
            trial.is_A_selected = trial.response_first == (trial.first_shown == 'A');
            contents.trials.push_back(trial);
        }
        contents.participants.push_back(tests::a_participant(number));
        contents.sessions.push_back(session);
    }
    return contents;
}

TEST(TrialsFile, ExportedTrialsGiveTheStatisticsOfTheStore) {
    for (const bool repeats : {false, true}) {
        const StoreContents contents = random_contents(repeats);
        const std::string csv = tests::trials_text(contents);
        for (const Kind kind : {Kind::kParticipant, Kind::kSimulated}) {
            const Analysis of_store =
                analyse(tally_trials("s", contents.sessions, contents.trials, "", kind));
            const Analysis of_file = analyse(tally_of(parse_trials(csv, "s"), "", kind));
            EXPECT_EQ(json_report(of_file), json_report(of_store));
            EXPECT_EQ(text_report(of_file), text_report(of_store));
            const bool is_paired = !repeats || kind == Kind::kSimulated;
            EXPECT_EQ(of_file.validity->by_level.at(0).same_participants.has_value(), is_paired);
        }
    }
}

TEST(TrialsFile, DamagedFilesAreReadOrRefusedWithTheirPlace) {
    std::string csv = tests::trials_text(random_contents(false));
    csv.resize(csv.find('\n', 6000) + 1);
    const std::string other = kHeader + "ann,x,y,1\nbob,y,x,0\ncleo,\"x\",y,true\n";
    constexpr std::array<std::string_view, 9> pieces{",",  "\"",   "\n",   "\r\n", "",
                                                     "-1", "1e99", "\xC3", "AB"};
    std::mt19937 random(7);
    int accepted = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string text = i % 2 == 0 ? csv : other;
        for (unsigned change = random() % 3; change < 3; ++change) {
            text.replace(random() % text.size(), random() % 4, pieces.at(random() % pieces.size()));
        }
        try {
            const Analysis analysis =
                analyse(tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant));
            EXPECT_THAT(json_report(analysis), Not(HasSubstr("nan")));
            ++accepted;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput) << error.what();
            EXPECT_THAT(error.what(), HasSubstr("t.csv"));
        }
    }
    EXPECT_GT(accepted, 20) << "some damage is harmless";
}

}  // namespace
}  // namespace obscura::analysis
