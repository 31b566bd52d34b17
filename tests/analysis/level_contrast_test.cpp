// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/level_contrast.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "analysis/presentation/text_report.h"
#include "analysis/statistics/sign_flip.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A condition of None against Blizzard24 and everybody's answer to it, '-' for none.
struct Asked {
    std::string id, scene, level, answers;
};

Analysis of(const std::vector<Asked>& conditions) {
    std::string text =
        "observer,study,condition,scene,validity,hypothesis,condition_A,condition_B,is_A_selected"
        "\n";
    for (const Asked& asked : conditions) {
        for (std::size_t who = 0; who < asked.answers.size(); ++who) {
            if (asked.answers[who] == '-') continue;
            text += fmt::format("p{:02},jakobsen2010,{},{},{},H1,None,Blizzard24,{:d}\n", who,
                                asked.id, asked.scene, asked.level, asked.answers[who] == 'A');
        }
    }
    return analyse(tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant));
}

TEST(LevelContrast, OfTwoScenesFlipsTheSignsOfEachParticipantsChange) {
    const Analysis analysis = of({{"a1", "hall", "moderate", "AABABAABAA"},
                                  {"a2", "hall", "high", "BABBBABBAB"},
                                  {"b1", "yard", "moderate", "ABAAABAAAB"},
                                  {"b2", "yard", "high", "BBBAABBAAB"}});
    ASSERT_EQ(analysis.validity->by_level.size(), 1U);
    const Comparison& both = analysis.validity->by_level[0];
    EXPECT_EQ(both.view, "hall and yard");
    // Changes of the ten, over both scenes together.
    const std::vector<std::int64_t> changes{2, 0, 1, 1, 0, 0, 2, 0, 0, 1};
    const auto expected = sign_flip(changes);
    EXPECT_NEAR(p_of(both)->p, expected->p.p, 1e-15);
    EXPECT_NEAR(expected->p.p, 2.0 / 32.0, 1e-15) << "all five changed one way";
    EXPECT_NEAR(both.differences.at(0).difference, 7.0 / 20.0, 1e-12);
    EXPECT_TRUE(both.contrast->is_exact);
    EXPECT_EQ(analysis.validity->by_pair.size(), 2U) << "each scene for itself beside it";
    EXPECT_THAT(text_report(analysis),
                AllOf(HasSubstr("None against Blizzard24 in hall and yard over moderate, high"),
                      HasSubstr("10 participants over 2 scenes")));
    EXPECT_EQ(analysis.verdicts.back().tests, 2U) << "H1 and one test of validity";
}

TEST(LevelContrast, MakesSharesOfDifferentNumbersOfConditionsWholeAsDefined) {
    // One condition at moderate, two at high: c = 2, d = B at high less twice B at moderate.
    const Analysis analysis = of({{"a1", "hall", "moderate", "ABABABABABAB"},
                                  {"a2", "hall", "high", "BBBBAABBBBAB"},
                                  {"a3", "hall", "high", "BABBBABAABBB"}});
    const Comparison& both = analysis.validity->by_level.at(0);
    const std::vector<std::int64_t> differences{2, -1, 2, 0, 1, -2, 2, -1, 1, 0, 1, 0};
    EXPECT_NEAR(both.contrast->p.p, sign_flip(differences)->p.p, 1e-15);
    EXPECT_NEAR(both.contrast->difference, 5.0 / 24.0, 1e-12);
}

TEST(LevelContrast, OfDifferencesBetweenScenesOnlyIsNone) {
    // Everybody B in the hall and A in the yard, whatever the light; no light in the yard is low.
    const std::string all_b(20, 'B');
    const std::string all_a(20, 'A');
    const Analysis analysis = of({{"a1", "hall", "moderate", all_b},
                                  {"a2", "hall", "high", all_b},
                                  {"b1", "yard", "moderate", all_a},
                                  {"b2", "yard", "high", all_a},
                                  {"c1", "pier", "high", all_a}});
    const Comparison& both = analysis.validity->by_level.at(0);
    EXPECT_EQ(both.contrast->p.p, 1.0);
    EXPECT_EQ(both.contrast->difference, 0.0);
    // Nobody differs from the others: the exact upper limit of 0 in 20.
    EXPECT_NEAR(both.contrast->interval.high, 1.0 - std::pow(.025, 1.0 / 20.0), 1e-12);
    EXPECT_EQ(analysis.validity->without_partner, std::vector<std::string>{"c1"});
}

TEST(LevelContrast, OverThreeLevelsOfSeveralScenesComparesEveryTwo) {
    const Analysis analysis = of({{"a1", "hall", "low", "ABABABABAB"},
                                  {"a2", "hall", "moderate", "AABBABABAB"},
                                  {"a3", "hall", "high", "BBABABABAB"},
                                  {"b2", "yard", "moderate", "ABABABABAA"},
                                  {"b3", "yard", "high", "ABABBBABAB"}});
    const auto& tests = analysis.validity->by_level;
    ASSERT_EQ(tests.size(), 3U);
    EXPECT_EQ(tests[0].levels, (std::vector<std::string>{"low", "moderate"}));
    EXPECT_TRUE(tests[0].same_participants.has_value()) << "one scene: McNemar";
    EXPECT_EQ(tests[2].levels, (std::vector<std::string>{"moderate", "high"}));
    EXPECT_EQ(tests[2].contrast->scenes, 2U);
    EXPECT_EQ(analysis.verdicts.back().tests, 4U);
}

TEST(LevelContrast, LeavesOutWhoDidNotAnswerAllUnlessMostDidNot) {
    const Analysis few = of({{"a1", "hall", "moderate", "AABABA"},
                             {"a2", "hall", "high", "BABBB-"},
                             {"b1", "yard", "moderate", "ABAAAB"},
                             {"b2", "yard", "high", "BBBAAB"}});
    EXPECT_EQ(few.validity->by_level.at(0).contrast->n, 5);
    EXPECT_EQ(few.validity->by_level.at(0).contrast->left_out, 1);
    // Each saw one of the scenes: nobody is complete, everybody counts with his own.
    const Analysis most = of({{"a1", "hall", "moderate", "AAB---"},
                              {"a2", "hall", "high", "BBB---"},
                              {"b1", "yard", "moderate", "---AAB"},
                              {"b2", "yard", "high", "---BBA"}});
    const LevelContrast& contrast = *most.validity->by_level.at(0).contrast;
    EXPECT_EQ(contrast.n, 6);
    EXPECT_FALSE(contrast.is_exact);
    EXPECT_NEAR(contrast.difference, 3.0 / 6.0, 1e-12);
    // (4 - 1)^2 / 5 is chi-square of one degree.
    EXPECT_NEAR(contrast.p.p, std::erfc(std::sqrt(9.0 / 5.0 / 2.0)), 1e-12);
    // Each saw one level only: nothing within participants.
    const Analysis apart = of({{"a1", "hall", "moderate", "AAB---"},
                               {"a2", "hall", "high", "---BBB"},
                               {"b1", "yard", "moderate", "AAB---"},
                               {"b2", "yard", "high", "---BBA"}});
    EXPECT_THAT(test_words(apart.validity->by_level.at(0)),
                HasSubstr("nobody answered at both levels of a scene"));
}

TEST(SignFlip, MeetsDarwinsMaize) {
    const auto test = sign_flip({49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48});
    EXPECT_NEAR(test->p.p, 2.0 * 863.0 / 32768.0, 1e-15);
    EXPECT_NEAR(test->p.p, .052673, 5e-7);
}

TEST(SignFlip, OfUnequalNumbersIsTheNormalApproximation) {
    const std::vector<double> values{.5, -.25, 1.0, 0.0, 1.0};
    const auto test = sign_flip_nearly(values);
    EXPECT_FALSE(test->is_exact);
    EXPECT_EQ(test->participants, 4);
    const double squared = 2.25 * 2.25 / (.25 + .0625 + 2.0);
    EXPECT_NEAR(test->p.p, std::erfc(std::sqrt(squared / 2.0)), 1e-12);
    EXPECT_FALSE(sign_flip_nearly({0.0, 0.0}).has_value());
    EXPECT_THROW((void)sign_flip_nearly({std::nan("")}), base::Error);
}

}  // namespace
}  // namespace obscura::analysis
