// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Attention checks, repeats and the rule of exclusion in a study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/manifest.h"
#include "stimuli/study_reader.h"
#include "tests/stimuli/attentive_study.h"

namespace obscura::stimuli {
namespace {

using testing::HasSubstr;

StudyReading read_attentive(const std::string& text) { return read_study(text, test_catalogue()); }

std::string edited(std::string_view from, std::string_view to) {
    std::string text = attentive_text();
    text.replace(text.find(from), from.size(), to);
    return text;
}

TEST(AttentionInStudy, ACheckExpectsASideAndARepeatShowsWhatItRepeats) {
    const StudyReading reading = read_attentive(attentive_text());
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    const Study& study = reading.study;
    ASSERT_EQ(study.conditions.size(), 4U);
    EXPECT_EQ(study.conditions[0].expected, '\0');
    EXPECT_EQ(study.conditions[2].expected, 'B');
    EXPECT_EQ(study.conditions[2].repeats, "");
    const Condition& again = study.conditions[3];
    EXPECT_EQ(again.repeats, "one");
    EXPECT_EQ(again.scene, "court");
    EXPECT_EQ(again.a.variant_name(), study.conditions[0].a.variant_name());
    EXPECT_EQ(again.b.parameters, study.conditions[0].b.parameters);
    EXPECT_EQ(study.exclusion.to_json(),
              R"({"min_catch_correct":0.8,"min_repeat_agreement":0.5,"min_response_time_s":0.2})");
}

TEST(AttentionInStudy, WithoutARuleTheTextIsEmptyAndAPartOfARuleIsARule) {
    EXPECT_EQ(read_attentive(std::string(kSmallStudy)).study.exclusion.to_json(), "");
    const StudyReading reading =
        read_attentive(std::string(kSmallStudy) + "[exclusion]\nmin_response_time_s = 1\n");
    EXPECT_EQ(to_lines(reading.problems, ""), "");
    EXPECT_EQ(reading.study.exclusion.to_json(), R"({"min_response_time_s":1.0})");
}

TEST(AttentionInStudy, ARepeatMayStandBeforeWhatItRepeats) {
    std::string text = attentive_text();
    const std::string repeat = "[[condition]]\nid = \"one-again\"\nrepeats = \"one\"\n";
    text.erase(text.find(repeat), repeat.size());
    text.insert(text.find("[[condition]]"), repeat);
    const StudyReading reading = read_attentive(text);
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    EXPECT_EQ(reading.study.conditions.front().b.technique, "blizzard");
}

constexpr std::string_view kIdentical = R"(
[[condition]]
id = "same"
scene = "court"
identical = true
a = { technique = "blizzard" }
b = { technique = "blizzard" }

[[condition]]
id = "same-again"
repeats = "same"
)";

TEST(AttentionInStudy, APairMayBeTheSameOnBothSidesWhereItSaysSo) {
    const StudyReading reading = read_attentive(std::string(kSmallStudy) + std::string(kIdentical));
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    EXPECT_FALSE(reading.study.conditions[0].identical);
    EXPECT_TRUE(reading.study.conditions[2].identical);
    EXPECT_TRUE(reading.study.conditions[3].identical);
}

TEST(AttentionInStudy, APairThatIsTheSameOnBothSidesIsRefusedWithTheKeyThatAllowsIt) {
    std::string text = std::string(kSmallStudy) + std::string(kIdentical);
    const std::string key = "identical = true\n";
    text.erase(text.find(key), key.size());
    EXPECT_THAT(to_lines(read_attentive(text).problems, "study"), HasSubstr("identical = true"));
}

TEST(AttentionInStudy, AnIdenticalPairHasNoSideToPickAndNoHypothesis) {
    for (const char* key : {"catch = \"a\"\n", "hypothesis = \"H1\"\n"}) {
        std::string text = std::string(kSmallStudy) + std::string(kIdentical);
        text.insert(text.find("identical"), key);
        EXPECT_THAT(to_lines(read_attentive(text).problems, "study"),
                    HasSubstr("identical: is true beside"))
            << key;
    }
    std::string text = std::string(kSmallStudy) + std::string(kIdentical);
    text.replace(text.find("= true"), 6, "= \"yes\"");
    EXPECT_THAT(to_lines(read_attentive(text).problems, "study"),
                HasSubstr("allowed is true or false"));
}

/// One edit of the study and the only problem that it makes.
struct Bad {
    std::string_view from;
    std::string_view to;
    int line;
    const char* fragment;
};

TEST(AttentionInStudy, EveryMistakeIsSaidAtItsLineWithWhatIsAllowed) {
    const std::vector<Bad> list{
        {"catch = \"b\"", "catch = \"B\"", 30, "\"B\" is no side, allowed are a, b"},
        {"catch = \"b\"", "catch = true", 30, "is no text, allowed are \"a\", \"b\""},
        {"repeats = \"one\"", "repeats = \"on\"", 36, "did you mean \"one\"?"},
        {"repeats = \"one\"", "repeats = 1", 36, "is an integer"},
        {"repeats = \"one\"", "repeats = \"check\"", 36, "is an attention check"},
        {"repeats = \"one\"", "repeats = \"one-again\"", 36, "is the condition itself"},
        {"repeats = \"one\"", "repeats = \"one\"\nscene = \"court\"", 37,
         "is not allowed beside repeats"},
        {"repeats = \"one\"", "repeats = \"one\"\ncatch = \"a\"", 37,
         "is not allowed beside repeats"},
        {"repeats = \"one\"", "repeats = \"one\"\nreapeats = 1", 37, "is an unknown key"},
        {"min_catch_correct = 0.8", "min_catch_correct = 1.5", 39, "allowed is 0 to 1"},
        {"min_catch_correct = 0.8", "min_catch_correct = nan", 39, "allowed is 0 to 1"},
        {"min_response_time_s = 0.2", "min_response_time_s = -1", 41, "allowed is 0 to 3600"},
        {"min_response_time_s", "min_response_time_ms", 41, "did you mean"},
    };
    for (const Bad& bad : list) {
        const StudyReading reading = read_attentive(edited(bad.from, bad.to));
        const std::string lines = to_lines(reading.problems, "s");
        ASSERT_FALSE(reading.problems.empty()) << bad.to;
        const bool said = std::any_of(
            reading.problems.begin(), reading.problems.end(), [&](const StudyProblem& problem) {
                return problem.line == bad.line &&
                       problem.message.find(bad.fragment) != std::string::npos;
            });
        EXPECT_TRUE(said) << bad.to << "\n" << lines;
    }
}

TEST(AttentionInStudy, ARuleThatNothingCanBeJudgedByIsRefused) {
    const StudyReading reading = read_attentive(std::string(kSmallStudy) +
                                                "[exclusion]\nmin_catch_correct = 0.8\n"
                                                "min_repeat_agreement = 0.5\n");
    const std::string lines = to_lines(reading.problems, "s");
    EXPECT_THAT(lines, HasSubstr("s:27: exclusion: min_catch_correct: no condition has the key"));
    EXPECT_THAT(lines, HasSubstr("s:28: exclusion: min_repeat_agreement: no condition has"));
}

TEST(AttentionInStudy, AStudyOfChecksAloneIsRefused) {
    std::string text(kSmallStudy);
    for (auto at = text.find("scene = \"court\""); at != std::string::npos;
         at = text.find("scene = \"court\"", at + 30)) {
        text.insert(at, "catch = \"a\"\n");
    }
    EXPECT_THAT(to_lines(read_attentive(text).problems, "s"),
                HasSubstr("needed is one to vote on"));
}

}  // namespace
}  // namespace obscura::stimuli
