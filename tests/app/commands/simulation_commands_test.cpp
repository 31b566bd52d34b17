// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The commands that simulate observers of a study of one's own: rehearse, and power STUDY.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/store/store.h"
#include "app/kiosk/choice_model.h"
#include "tests/app/commands/run_program.h"
#include "tests/app/commands/study_text.h"

namespace obscura::app {
namespace {

using analysis::Kind;
using analysis::Store;
using testing::HasSubstr;

std::string own_study() {
    return study_head("own", "latin-square", "sides = \"trial\"\n") +
           scene_text("day", "atrium", "high") + scene_text("dusk", "atrium", "moderate") +
           condition_text("one", "day", "\"none\"", "\"blizzard\"") +
           condition_text("two", "dusk", "\"none\"", "\"blizzard\"") + R"([[hypothesis]]
id = "P"
statement = "It looks better."
kind = "preference"
conditions = ["one", "two"]
[[hypothesis]]
id = "Q"
statement = "Light matters."
kind = "interaction"
pairs = [["one", "two"]]
)";
}

class SimulationCommands : public testing::Test {
  protected:
    void SetUp() override { base::write_file_atomically(folder_ / "own.toml", own_study()); }

    [[nodiscard]] Store store() const {
        return {"sqlite3://" + (folder_ / "obscura-data/rehearsal/own.sqlite").string(),
                Store::Access::kReadOnly};
    }

    tests::TemporaryFolder folder_;
};

TEST_F(SimulationCommands, ARehearsalFillsAStoreOfSimulatedSessionsThatAnalyzeReads) {
    const ProgramRun run =
        run_program(folder_, "rehearse own.toml --participants 20 --share one=1 --share 0 --quiet");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("simulated"));
    const auto sessions = store().sessions();
    ASSERT_EQ(sessions.size(), 20U);
    for (const auto& session : sessions) {
        EXPECT_EQ(session.kind, Kind::kSimulated);
        EXPECT_THAT(session.study_plan, HasSubstr("It looks better."));
    }
    for (const auto& trial : store().trials()) {
        EXPECT_EQ(trial.is_A_selected, trial.condition == "two");
    }
    const ProgramRun analysed = run_program(
        folder_, "analyze --db sqlite3://obscura-data/rehearsal/own.sqlite --kind simulated");
    EXPECT_EQ(analysed.exit_code, 0) << analysed.err;
    EXPECT_THAT(analysed.out, HasSubstr("simulated"));
    EXPECT_THAT(analysed.out, HasSubstr("Q: the effect differs with lighting"));
}

TEST_F(SimulationCommands, ARehearsalReplacesItselfAndNoAnswersOfPeople) {
    const auto rehearse = [&] {
        return run_program(folder_, "rehearse own.toml --participants 2 --store s.sqlite --quiet");
    };
    ASSERT_EQ(rehearse().exit_code, 0);
    ASSERT_EQ(rehearse().exit_code, 0);
    Store people("sqlite3://" + (folder_ / "s.sqlite").string(), Store::Access::kReadWrite);
    EXPECT_EQ(people.sessions().size(), 2U);
    auto participant = people.participants().at(0);
    auto session = people.sessions().at(0);
    participant.participant_id = session.participant_id = "p";
    session.session_id = "s";
    participant.kind = session.kind = Kind::kParticipant;
    session.state = analysis::SessionState::kOpen;
    session.ended_utc = "";
    people.begin_session(participant, session);
    const ProgramRun refused = rehearse();
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("holds answers of participants"));
    EXPECT_EQ(people.sessions().size(), 3U);
}

TEST_F(SimulationCommands, WhatObserversCannotBeIsRefusedWithWhatIsAllowed) {
    const std::vector<std::pair<const char*, const char*>> mistakes{
        {"--share three=.5", "has no condition three to vote on, allowed are one, two"},
        {"--share one=1.5", "--share one=1.5: allowed is a share of B from 0 to 1"},
        {"--share one=", "allowed is a share of B"},
        {"--share nan", "allowed is a share of B"},
        {"--sd -1", "--sd -1: allowed is 0 to 10"},
        {"--order-bias 1", "--order-bias 1: allowed is more than 0 and less than 1"},
        {"--careless 2", "--careless 2: allowed is 0 to 1"},
    };
    for (const auto& [option, said] : mistakes) {
        const ProgramRun run =
            run_program(folder_, std::string("rehearse own.toml --participants 2 ") + option);
        EXPECT_EQ(run.exit_code, 2) << option;
        EXPECT_THAT(run.err, HasSubstr(said)) << option;
    }
}

TEST_F(SimulationCommands, PowerOfAStudyIsOfEveryVerdictWithItsErrorAndTheSameForASeed) {
    const std::string command =
        "power own.toml --share .9 --sd 0 --participants 40 --studies 200 --json";
    const ProgramRun run = run_program(folder_, command);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run_program(folder_, command).out, run.out);
    EXPECT_NE(run_program(folder_, command + " --seed 5").out, run.out);
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(json["verdicts"].size(), 6U) << "found, equal and wrong, of P and of Q";
    const auto& preferred = json["verdicts"][0];
    EXPECT_EQ(preferred["hypothesis"], "P");
    EXPECT_GT(preferred["at"]["frequency"], .99) << "72 of 80 votes";
    EXPECT_EQ(preferred["needed"]["participants"].get<int>() % 4, 0) << "whole blocks";
    EXPECT_GE(preferred["needed"]["frequency"].get<double>(), .7);
    const auto& wrong = json["verdicts"][2];
    EXPECT_EQ(wrong["is_error"], true);
    EXPECT_LT(wrong["at"]["frequency"].get<double>(), .1);
    const double share = wrong["at"]["frequency"].get<double>();
    EXPECT_NEAR(wrong["at"]["standard_error"].get<double>(), std::sqrt(share * (1 - share) / 200),
                1e-12);
}

TEST_F(SimulationCommands, PowerOfAStudySaysWhatOfTheStudyItDoesNotSimulate) {
    const std::string command =
        "power own.toml --share .95 --sd 0 --participants 12 --studies 100 --json --quiet";
    EXPECT_TRUE(nlohmann::json::parse(run_program(folder_, command).out)["not_simulated"].empty());
    base::write_file_atomically(folder_ / "own.toml",
                                own_study() +
                                    "[stopping]\nlooks = [6, 12]\nspending = "
                                    "\"pocock\"\n[exclusion]\nmin_response_time_s = 0.3\n");
    const ProgramRun run = run_program(folder_, command);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto passed_over = nlohmann::json::parse(run.out)["not_simulated"];
    ASSERT_EQ(passed_over.size(), 2U);
    EXPECT_THAT(passed_over[0].get<std::string>(), HasSubstr("2 looks are planned"));
    EXPECT_THAT(passed_over[1].get<std::string>(), HasSubstr("0.3 s"));
}

TEST_F(SimulationCommands, PowerOfAStudyRefusesWhatIsOfOneConditionAlone) {
    EXPECT_EQ(run_program(folder_, "power own.toml --conditions 3").exit_code, 2);
    EXPECT_EQ(run_program(folder_, "power --sd 1").exit_code, 2);
    EXPECT_EQ(run_program(folder_, "power own.toml --share .4").exit_code, 2);
    EXPECT_EQ(run_program(folder_, "power own.toml --studies 3").exit_code, 2);
}

TEST(Observers, PreferBAsOftenAsTheyAreToldHoweverMuchTheyDiffer) {
    kiosk::ChoiceModel model;
    model.probability_of_b = {.7, .3};
    model.sd = 2.0;
    base::Random random(3);
    constexpr int kObservers = 20000;
    int first = 0;
    int both = 0;
    for (int number = 0; number < kObservers; ++number) {
        kiosk::Observer observer(model, random);
        const bool one = observer.chooses_b(0, true);
        const bool two = observer.chooses_b(1, false);
        if (one) ++first;
        if (one && two) ++both;
    }
    const double share = static_cast<double>(first) / kObservers;
    EXPECT_NEAR(share, .7, 4.0 * std::sqrt(.21 / kObservers));
    EXPECT_GT(static_cast<double>(both) / kObservers, .7 * .3 + .03)
        << "who likes B likes it twice";
}

TEST(Observers, WithABiasChooseTheSecondOfTwoAlikeImagesSoOftenAndTheCarelessByChance) {
    kiosk::ChoiceModel model;
    model.probability_of_b = {.5, .95};
    model.is_check = {false, true};
    model.order_bias = .7;
    base::Random random(4);
    constexpr int kObservers = 20000;
    int second = 0;
    int careless_right = 0;
    kiosk::ChoiceModel careless = model;
    careless.careless = 1.0;
    for (int number = 0; number < kObservers; ++number) {
        const bool b_second = number % 2 == 0;
        if (kiosk::Observer(model, random).chooses_b(0, b_second) == b_second) ++second;
        if (kiosk::Observer(careless, random).chooses_b(1, b_second)) ++careless_right;
    }
    EXPECT_NEAR(static_cast<double>(second) / kObservers, .7, 4.0 * std::sqrt(.21 / kObservers));
    EXPECT_NEAR(static_cast<double>(careless_right) / kObservers, .5,
                4.0 * std::sqrt(.25 / kObservers));
}

}  // namespace
}  // namespace obscura::app
