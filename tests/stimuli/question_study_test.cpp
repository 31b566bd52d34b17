// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// [[question]] in a study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/questions/answers.h"
#include "analysis/study_plan.h"
#include "stimuli/study_reader.h"
#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// The small study with questions at its end in place of its own, and more keys in [study].
StudyReading read_asking(const std::string& questions, const std::string& keys = "") {
    std::string text(kSmallStudy);
    const std::string own = "question = \"Which?\"\n";
    text.replace(text.find(own), own.size(), keys);
    return read_study(text + questions, test_catalogue());
}

std::string problems_asking(const std::string& questions, const std::string& keys = "") {
    return to_lines(read_asking(questions, keys).problems, "study");
}

constexpr const char* kChoice =
    "\n[[question]]\nid = \"real\"\nkind = \"choice\"\ntext = \"Which is real?\"\n";

TEST(QuestionsOfStudy, EveryKindIsReadWithItsLabelsKeysAndSteps) {
    const StudyReading reading = read_asking(
        "\n[[question]]\nid = \"real\"\nkind = \"choice-or-none\"\ntext = \"Which is real?\"\n"
        "labels = [\"One\", \"Two\", \"Neither\"]\nkeys = [[\"a\", \"left\"], [\"l\"], [\"g\"]]\n"
        "[[question]]\nid = \"like\"\nkind = \"rating\"\ntext = \"How good?\"\nof = \"images\"\n"
        "labels = [\"bad\", \"fair\", \"good\"]\n"
        "[[question]]\nid = \"sure\"\nkind = \"confidence\"\ntext = \"How sure?\"\n"
        "labels = [\"not\", \"very\"]\nmin = 0\nmax = 5\n",
        "ties = \"davidson\"\n");
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    ASSERT_THAT(reading.questions.list, SizeIs(3));
    EXPECT_EQ(reading.questions.ties, Ties::kDavidson);
    EXPECT_EQ(reading.study.question, "Which is real?");
    const Question& real = reading.questions.list[0];
    EXPECT_EQ(real.kind, QuestionKind::kChoiceOrNone);
    EXPECT_THAT(real.keys,
                ElementsAre(ElementsAre("a", "left"), ElementsAre("l"), ElementsAre("g")));
    EXPECT_EQ(real.label_of(2), "Neither");
    const Question& like = reading.questions.list[1];
    EXPECT_TRUE(like.each_image);
    EXPECT_EQ(like.answer_count(), 3);
    EXPECT_EQ(like.label_of(1), "fair");
    const Question& sure = reading.questions.list[2];
    EXPECT_EQ(sure.answer_count(), 6);
    EXPECT_EQ(sure.label_of(1), "");
    EXPECT_EQ(sure.label_of(5), "very");
    // Everything that participants read is known, for fonts and languages.
    EXPECT_THAT(reading.study.shown_texts,
                testing::Contains(testing::Field(&ShownText::text, "fair")));
}

TEST(QuestionsOfStudy, AStudyWithoutThemAsksItsOneQuestion) {
    const StudyReading reading = read_study(kSmallStudy, test_catalogue());
    EXPECT_TRUE(reading.questions.list.empty());
    EXPECT_EQ(reading.study.question, "Which?");
    EXPECT_EQ(plan_json(reading.study, reading.questions), reading.study.plan_json());
    EXPECT_THAT(problems_asking(""), HasSubstr("study: question is missing"));
}

TEST(QuestionsOfStudy, WhatIsAskedIsFixedInThePlanOfEachSession) {
    const StudyReading reading = read_asking(
        std::string(kChoice) +
        "[[question]]\nid = \"depth\"\nkind = \"choice-or-none\"\ntext = \"Which is deeper?\"\n");
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    const std::string plan = plan_json(reading.study, reading.questions);
    EXPECT_FALSE(analysis::study_plan_problem(plan).has_value());
    const analysis::AskedQuestions asked = analysis::asked_questions(plan);
    ASSERT_THAT(asked.list, SizeIs(2));
    EXPECT_EQ(asked.list[1].id, "depth");
    EXPECT_EQ(asked.list[1].text, "Which is deeper?");
    EXPECT_EQ(asked.ties, "split");
    EXPECT_FALSE(asked.first_has_ties());
}

TEST(QuestionsOfStudy, EverythingWrongIsNamedWithItsLineAndWhatIsAllowed) {
    // The small study without its question has 25 lines.
    EXPECT_THAT(
        problems_asking("\n[[question]]\nid = \"sure\"\nkind = \"confidence\"\ntext = \"Sure?\"\n"
                        "labels = [\"no\", \"yes\"]\n"),
        HasSubstr("kind: \"confidence\" cannot be the first question, by which the pairs are "
                  "compared; allowed is choice or choice-or-none"));
    const std::string after(kChoice);
    EXPECT_THAT(problems_asking(after + "[[question]]\nid = \"like\"\nkind = \"rating\"\n"
                                        "text = \"How good?\"\n"),
                HasSubstr("question \"like\": labels is missing"));
    EXPECT_THAT(problems_asking(after + "[[question]]\nid = \"like\"\nkind = \"rating\"\n"
                                        "text = \"T\"\nlabels = [\"a\", \"b\"]\nmax = 12\n"),
                HasSubstr("makes a scale of 12 steps from 1 to 12, allowed are 2 to 11"));
    EXPECT_THAT(
        problems_asking(after + "[[question]]\nid = \"like\"\nkind = \"rating\"\n"
                                "text = \"T\"\nlabels = [\"a\", \"b\"]\nmin = 0\nmax = 10\n"),
        HasSubstr("keys: is needed: steps 0 to 10 are not digits"));
    EXPECT_THAT(problems_asking(after + "[[question]]\nid = \"real\"\nkind = \"choice\"\n"
                                        "text = \"T\"\n"),
                HasSubstr("id: \"real\" is used twice"));
    EXPECT_THAT(problems_asking(after + "keys = [[\"1\"], [\"1\"]]\n"),
                HasSubstr("keys: \"1\" stands for two answers"));
    EXPECT_THAT(problems_asking(after + "keys = [[\"1\"], [\"F1\"]]\n"),
                HasSubstr("study:30: question \"real\": keys: \"F1\" is no key, allowed is"));
    EXPECT_THAT(problems_asking(after + "keys = [[\"1\"]]\n"), HasSubstr("keys: has 1 values"));
    EXPECT_THAT(problems_asking(after + "labels = [\"a\", \"a\"]\n"),
                HasSubstr("labels: holds what is no text, an empty one or one twice"));
    EXPECT_THAT(problems_asking(after + "min = 1\n"), HasSubstr("\"min\" is an unknown key"));
    EXPECT_THAT(problems_asking(after, "ties = \"split\"\n"),
                HasSubstr("ties: has no effect without a [[question]] of kind"));
    EXPECT_THAT(problems_asking(after, "question = \"Which?\"\n"),
                HasSubstr("question: has no effect beside [[question]]"));
}

}  // namespace
}  // namespace obscura::stimuli
