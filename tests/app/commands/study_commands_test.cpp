// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_program.h"
#include "tests/app/commands/study_text.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string good_study() {
    return study_head("good", "williams") + scene_text("stone", "relic", "low") +
           condition_text("one", "stone", "\"none\"", "\"blizzard\"") +
           condition_text("two", "stone", "\"crytek\"", "\"raymarch\"");
}

class StudyCommands : public testing::Test {
  protected:
    void SetUp() override {
        base::write_file_atomically(folder_.path() / "good.toml", good_study());
    }

    /// good.toml with one text replaced, as bad.toml.
    void write_bad(const std::string& from, const std::string& to) {
        std::string text = good_study();
        text.replace(text.find(from), from.size(), to);
        base::write_file_atomically(folder_.path() / "bad.toml", text);
    }

    tests::TemporaryFolder folder_;
};

TEST_F(StudyCommands, CheckCountsWhatIsInAStudyWithoutProblems) {
    const ProgramRun run = run_program(folder_, "check good.toml");
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    EXPECT_EQ(run.out, "good.toml: 2 conditions, 4 images, no problems\n");
}

TEST_F(StudyCommands, CheckPrintsALineForEachProblemAndExitsWith2) {
    write_bad("seed = 7", "sed = 7\ngrey_ms = -1");
    const ProgramRun run = run_program(folder_, "check bad.toml");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.out, StartsWith("bad.toml:7: study: \"sed\" is an unknown key"));
    EXPECT_THAT(run.out, HasSubstr("\nbad.toml:8: study: grey_ms: -1 is out of range"));
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 2);
}

TEST_F(StudyCommands, AStudyThatIsNotThereOrIsNoFileIsBadInput) {
    for (const char* arguments : {"check nothing.toml", "plan --participants 1 .", "check ''/"}) {
        const ProgramRun run = run_program(folder_, arguments);
        EXPECT_EQ(run.exit_code, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_THAT(run.err, StartsWith("obscura: ")) << arguments;
    }
}

TEST_F(StudyCommands, PlanRefusesABadStudyWithEveryProblem) {
    write_bad("\"crytek\"", "\"crytek\", samples = 12");
    const ProgramRun run = run_program(folder_, "plan bad.toml --participants 4");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("bad.toml:21: condition \"two\", a: samples: 12"));
}

TEST_F(StudyCommands, PlanRefusesNumbersOfParticipantsOutsideItsRange) {
    for (const char* count : {"0", "1000001", "1.5", ""}) {
        const ProgramRun run =
            run_program(folder_, std::string("plan good.toml --participants ") + count);
        EXPECT_EQ(run.exit_code, 2) << count;
        EXPECT_EQ(run.out, "") << count;
        EXPECT_THAT(run.err, HasSubstr("--participants")) << count;
    }
    EXPECT_EQ(run_program(folder_, "plan good.toml").exit_code, 2);
}

TEST_F(StudyCommands, PlanShowsEveryParticipantAndTheVerdicts) {
    const ProgramRun run = run_program(folder_, "plan good.toml --participants 4");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("participant  square  row  swapped"));
    EXPECT_THAT(run.out, HasSubstr("-a"));
    EXPECT_THAT(run.out, HasSubstr("-b"));
    EXPECT_THAT(run.out, HasSubstr("4 participants are 1 whole block of 4."));
    EXPECT_EQ(run.out.find("does not hold"), std::string::npos) << run.out;
}

TEST_F(StudyCommands, PlanSaysWhereTheNumberOfParticipantsBreaksTheBalance) {
    const ProgramRun run = run_program(folder_, "plan good.toml --participants 7");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(run.out, HasSubstr("does not hold   each image of a pair first equally often: "
                                   "A first 4, B first 3"));
    EXPECT_THAT(run.out, HasSubstr("no multiple of the block of 4"));
    EXPECT_THAT(run.out, HasSubstr("the nearest are 4 and 8"));
}

TEST_F(StudyCommands, PlanAsJsonHasAnEntryForEachParticipantAndTheSameVerdicts) {
    const ProgramRun run = run_program(folder_, "plan good.toml --participants 7 --json");
    ASSERT_EQ(run.exit_code, 0);
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["n_participants"], 7);
    EXPECT_EQ(json["block"], 4);
    EXPECT_EQ(json["whole_blocks"], false);
    EXPECT_EQ(json["balance"]["each_condition_once_per_row"], true);
    EXPECT_EQ(json["balance"]["each_image_first_equally_often"], false);
    EXPECT_EQ(json["balance"]["a_first"], nlohmann::json({4, 4}));
    ASSERT_EQ(json["participants"].size(), 7U);
    EXPECT_EQ(json["participants"][2]["participant"], 3);
    EXPECT_EQ(json["participants"][2]["swapped"], true);
    EXPECT_EQ(json["participants"][2]["first_images"], nlohmann::json({"b", "b"}));
    EXPECT_EQ(json["participants"][2]["conditions"], json["participants"][0]["conditions"]);
}

TEST_F(StudyCommands, PlanProvesThatSidesOfATrialBalanceWithinEverySession) {
    write_bad("seed = 7", "seed = 7\nsides = \"trial\"");
    const ProgramRun run = run_program(folder_, "plan bad.toml --participants 4");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("sides trial"));
    EXPECT_THAT(run.out, HasSubstr("holds           each side first equally often in each session: "
                                   "A first in 1 of 2 pairs in 4 sessions"));
    const ProgramRun by_session = run_program(folder_, "plan good.toml --participants 4");
    EXPECT_THAT(by_session.out, HasSubstr("sides = \"trial\" does that"));
}

TEST_F(StudyCommands, PlanShowsTheFamilyAndWhatCannotBePooledBeforeAnybodyAnswers) {
    write_bad("b = { technique = \"raymarch\" }",
              "b = { technique = \"hbao\" }\n"
              "[[hypothesis]]\nid = \"P\"\nstatement = \"More is better.\"\n"
              "kind = \"preference\"\nconditions = [\"one\"]\n"
              "[[hypothesis]]\nid = \"Q\"\nstatement = \"All of it.\"\n"
              "kind = \"preference\"\nconditions = [\"one\", \"two\"]\n");
    const ProgramRun run = run_program(folder_, "plan bad.toml --participants 4");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("P, primary preference, margin 15 points: one\n"
                                   "      More is better.\n"));
    EXPECT_THAT(run.out, HasSubstr("cannot be tested, and counts as p = 1"));
    EXPECT_THAT(run.out, HasSubstr("Holm's correction is over 2 tests"));
    EXPECT_THAT(run_program(folder_, "check bad.toml").out,
                HasSubstr("warning: hypothesis Q cannot be tested"));
}

TEST_F(StudyCommands, HelpNamesTheOptions) {
    EXPECT_THAT(run_program(folder_, "plan --help").out, HasSubstr("--participants"));
    EXPECT_THAT(run_program(folder_, "check --help").out, HasSubstr("STUDY"));
}

}  // namespace
}  // namespace obscura::app
