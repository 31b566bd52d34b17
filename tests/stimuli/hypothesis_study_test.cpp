// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The [[hypothesis]] tables of a study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/conclusions/published_study.h"
#include "analysis/study_plan.h"
#include "stimuli/study_reader.h"
#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The small study has 27 lines; a second level of its scene, and its first pair there.
constexpr std::string_view kTwoLevels = R"(
[[scene]]
id = "dusk"
source = "atrium"
camera = "nave"
validity = "moderate"

[[condition]]
id = "three"
scene = "dusk"
a = { technique = "none" }
b = { technique = "blizzard", radius_m = 0.8 }
)";

constexpr std::string_view kFamily = R"(
[[hypothesis]]
id = "P"
statement = "It looks better."
kind = "preference"
conditions = ["one", "three"]
margin = 0.1

[[hypothesis]]
id = "Q"
statement = "Light matters."
kind = "interaction"
pairs = [["one", "three"]]
role = "secondary"
)";

std::string small_with(std::string_view family) {
    return std::string(kSmallStudy) + std::string(kTwoLevels) + std::string(family);
}

std::string with_family_edited(std::string_view from, std::string_view to) {
    std::string text = small_with(kFamily);
    text.replace(text.find(from), from.size(), to);
    return text;
}

std::string problems_in(const std::string& text) {
    return to_lines(read_study(text, test_catalogue()).problems, "study");
}

TEST(Hypotheses, AreReadWithWhatTheyTakeAndWrittenAsThePlanThatSessionsCarry) {
    const StudyReading reading = read_study(small_with(kFamily), test_catalogue());
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    EXPECT_EQ(reading.study.plan_json(),
              R"({"hypotheses":[{"id":"P","statement":"It looks better.","kind":"preference",)"
              R"("conditions":["one","three"],"margin":0.1,"role":"primary"},)"
              R"({"id":"Q","statement":"Light matters.","kind":"interaction",)"
              R"("pairs":[["one","three"]],"margin":0.15,"role":"secondary"}]})");
    EXPECT_EQ(reading.study.conditions[0].hypothesis, "P") << "the first preference that takes it";
    EXPECT_EQ(reading.study.conditions[1].hypothesis, "");
    const analysis::StudyPlan plan = analysis::study_plan(reading.study.plan_json(), "here");
    ASSERT_EQ(plan.hypotheses.size(), 2U);
    EXPECT_TRUE(plan.hypotheses[1].is_interaction);
    EXPECT_FALSE(plan.hypotheses[1].is_primary);
    EXPECT_EQ(plan.hypotheses[0].margin, 0.1);
}

TEST(Hypotheses, ClaimAccuracyOnlyWhereTheySaySoAndTheBuiltInOnesThatDo) {
    EXPECT_FALSE(read_study(small_with(kFamily), test_catalogue()).study.hypotheses[0].accuracy);
    std::string claims;
    for (const Hypothesis& own : read_study(builtin_text(), test_catalogue()).study.hypotheses) {
        if (own.accuracy) claims += own.id + ' ';
    }
    EXPECT_EQ(claims, "H2 H2-IV ");
}

TEST(Hypotheses, AStudyWithoutAnyFixesNothing) {
    const StudyReading reading = read_study(std::string(kSmallStudy), test_catalogue());
    EXPECT_EQ(reading.study.plan_json(), "");
}

TEST(Hypotheses, OfTheBuiltInStudyAreThoseThatItsPublishedVotesAreTestedBy) {
    const StudyReading reading = read_study(builtin_text(), test_catalogue());
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    EXPECT_EQ(analysis::study_plan(reading.study.plan_json(), "here").hypotheses,
              analysis::published_hypotheses());
}

struct Mistake {
    std::string_view from;
    std::string_view to;
    std::string_view said;
};

TEST(Hypotheses, WhatIsWrongInThemIsSaidWithItsLineAndWhatIsAllowed) {
    const std::vector<Mistake> mistakes{
        {R"("one", "three"])", R"("one", "thre"])",
         R"(study:43: hypothesis "P": conditions: "thre" is no condition, allowed are one, two, )"
         R"(three; did you mean "three"?)"},
        {R"("one", "three"])", R"("one", "one"])", "\"one\" stands there twice"},
        {R"(["one", "three"])", "[]", "is empty, allowed are one or more of one, two, three"},
        {R"(["one", "three"])", "\"one\"", "study:43: hypothesis \"P\": conditions"},
        {R"([["one", "three"]])", R"([["one", "two"]])",
         "one, two show other variants, allowed are two or three conditions with the same two "
         "variants in one scene and camera, each at another level of validity"},
        {R"([["one", "three"]])", R"([["one"]])", "holds what is no pair"},
        {R"([["one", "three"]])", R"([["one", "three"], ["three", "one"]])", "stand there twice"},
        {"margin = 0.1", "margin = 0.6", "margin: 0.6"},
        {"margin = 0.1", "margin = nan", "margin: "},
        {"kind = \"preference\"", "kind = \"preferred\"",
         "\"preferred\" is unknown, allowed are preference, interaction"},
        {"role = \"secondary\"", "role = \"secondary\"\naccuracy = true",
         "accuracy: is not allowed for kind interaction"},
        {"kind = \"preference\"", "kind = \"interaction\"",
         "conditions: is not allowed for kind interaction, which takes pairs"},
        {"statement = \"It looks better.\"", "", "statement"},
        {"statement = \"It looks better.\"", "statement = \" \"", "allowed is a sentence"},
        {"id = \"Q\"", "id = \"P\"", "\"P\" is used twice"},
        {"role = \"secondary\"", "role = \"main\"", "allowed are primary, secondary"},
        {"margin = 0.1", "role = \"secondary\"", "every [[hypothesis]] is secondary"},
        {"scene = \"dusk\"", "scene = \"dusk\"\nhypothesis = \"R\"",
         "study:36: condition \"three\": hypothesis: \"R\" is not defined by a [[hypothesis]], "
         "defined are P, Q"},
        {"scene = \"dusk\"", "scene = \"court\"", "are at one level of validity"},
        {"source = \"atrium\"\ncamera = \"nave\"\nvalidity = \"moderate\"",
         "source = \"figures\"\ncamera = \"pair\"\nvalidity = \"moderate\"",
         "show other scenes or cameras"},
        {"role = \"secondary\"\n",
         "[[hypothesis]]\nid = \"S\"\nstatement = \"Again.\"\nkind = \"interaction\"\n"
         "pairs = [[\"one\", \"three\"]]\n",
         "hypothesis \"S\" is a second interaction, allowed is one"},
    };
    for (const Mistake& mistake : mistakes) {
        EXPECT_THAT(problems_in(with_family_edited(mistake.from, mistake.to)),
                    HasSubstr(mistake.said))
            << mistake.to;
    }
}

TEST(Hypotheses, TakeNoAttentionCheckAndNoRepeat) {
    const std::string again = "[[condition]]\nid = \"again\"\nrepeats = \"one\"\n";
    EXPECT_THAT(problems_in(with_family_edited(R"("one", "three"])", R"("one", "again"])") + again),
                HasSubstr("\"again\" is no condition that people vote on"));
}

TEST(Hypotheses, AreAllOfOnePlanInTheStoreOrNoneAtAll) {
    for (const char* text :
         {"[]", "{\"hypotheses\":1}", "{\"hypotheses\":[{\"id\":\"P\"}]}", "{\"other\":1}",
          R"({"hypotheses":[{"id":"P","kind":"preference","conditions":["a"],"margin":0.6}]})",
          R"({"hypotheses":[{"id":"P","kind":"preference","pairs":[["a","b"]]}]})",
          R"({"hypotheses":[{"id":"","kind":"preference","conditions":["a"]}]})"}) {
        EXPECT_TRUE(analysis::study_plan_problem(text).has_value()) << text;
    }
    EXPECT_FALSE(analysis::study_plan_problem("").has_value());
}

}  // namespace
}  // namespace obscura::stimuli
