// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/conclusions/analysis.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/summary.h"
#include "analysis/presentation/text_report.h"
#include "analysis/published_votes.h"
#include "tests/analysis/records_for_test.h"

namespace obscura::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

/// One completed session for each row; row[i] is whether B was chosen in condition i, which is
/// Crytek24 against Blizzard24 at low, moderate or high validity. B is shown second in every other
/// session.
struct Study {
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;

    void add(const std::vector<bool>& row) {
        constexpr std::array<const char*, 3> levels{"low", "moderate", "high"};
        const int number = static_cast<int>(sessions.size());
        sessions.push_back(tests::a_session(number));
        sessions.back().state = SessionState::kCompleted;
        for (std::size_t i = 0; i < row.size(); ++i) {
            TrialRecord& trial = trials.emplace_back(tests::a_trial(number, static_cast<int>(i)));
            trial.condition_A = "Crytek24";
            trial.validity = levels.at(i);
            trial.first_shown = number % 2 == 0 ? 'A' : 'B';
            trial.is_A_selected = !row[i];
            trial.response_first = trial.is_A_selected == (trial.first_shown == 'A');
        }
    }
    [[nodiscard]] Analysis analysed() const {
        return analyse(tally_trials("s", sessions, trials, "", Kind::kParticipant));
    }
};

Study nine_participants() {
    Study study;
    for (const std::vector<bool>& row : std::vector<std::vector<bool>>{{1, 0, 1},
                                                                       {0, 1, 1},
                                                                       {1, 1, 1},
                                                                       {0, 1, 0},
                                                                       {0, 1, 0},
                                                                       {1, 0, 1},
                                                                       {0, 1, 0},
                                                                       {1, 1, 1},
                                                                       {0, 1, 0}}) {
        study.add(row);
    }
    return study;
}

TEST(H3, OfTheSameParticipantsIsCochransQAndMcNemar) {
    const Analysis analysis = nine_participants().analysed();
    const json h3 = json::parse(json_report(analysis))["hypotheses"]["H3"];
    const json& levels = h3["comparisons"][0];
    // Columns 4, 7, 5; rows with one or two yes: 7, so that Q = 3 * 2 * (14/3) / 14 = 2.
    EXPECT_NEAR(levels["same_participants"]["cochran_q"].get<double>(), 2.0, 1e-12);
    EXPECT_EQ(levels["same_participants"]["n"], 9);
    EXPECT_NEAR(levels["p"].get<double>(), std::exp(-1.0), 1e-12) << "chi-square tail, df 2";
    EXPECT_EQ(levels["df"], 2) << "the counts-only test stays beside it";
    const json& low_moderate = h3["pairs"][0];
    EXPECT_EQ(low_moderate["same_participants"]["mcnemar"]["b_to_a"], 2);
    EXPECT_EQ(low_moderate["same_participants"]["mcnemar"]["a_to_b"], 5);
    EXPECT_NEAR(low_moderate["p"].get<double>(), 2.0 * 29.0 / 128.0, 1e-12);
    EXPECT_EQ(test_words(analysis.validity->by_level.at(0)),
              "Cochran's Q on the same 9 participants, Q 2, df 2, p = .368");
    EXPECT_THAT(text_report(analysis), HasSubstr("McNemar's exact test on the same 9"));
}

TEST(H3, LeavesOutParticipantsWhoDidNotAnswerAll) {
    Study study = nine_participants();
    study.add({1, 0});
    const Analysis analysis = study.analysed();
    const auto& same = analysis.validity->by_level.at(0).same_participants;
    EXPECT_EQ(same->n, 9);
    EXPECT_EQ(same->incomplete, 1);
    EXPECT_NEAR(same->cochran_q->statistic, 2.0, 1e-12);
    EXPECT_EQ(analysis.validity->by_pair.at(0).same_participants->n, 10);
    EXPECT_THAT(test_words(analysis.validity->by_level.at(0)), HasSubstr("1 who did not answer"));
}

TEST(H3, IsFromCountsWhereParticipantsRepeatedAConditionOrAreNotKnown) {
    Study study = nine_participants();
    study.sessions.push_back(study.sessions.front());
    study.sessions.back().session_id = "again";
    study.trials.push_back(study.trials.front());
    study.trials.back().session_id = "again";
    const std::string words = test_words(study.analysed().validity->by_level.at(0));
    EXPECT_THAT(words, AllOf(HasSubstr("from counts alone"),
                             HasSubstr("answered condition C0 more than once")));
    const Analysis published = analyse(published_votes());
    EXPECT_THAT(text_report(published), AllOf(HasSubstr("chi-square 3.692, df 2, p = .158"),
                                              HasSubstr("Fisher's exact p = .149")));
    EXPECT_THAT(test_words(published.validity->by_level.at(0)),
                HasSubstr("the answers of each participant are not known"));
}

TEST(H3, OfPeopleWhoNeverChangedTheAnswerLeavesOpenWhatSoFewCannotShow) {
    Study three_levels;
    for (int i = 0; i < 5; ++i) three_levels.add({i < 3, i < 3, i < 3});
    const Comparison comparison = three_levels.analysed().validity->by_level.at(0);
    EXPECT_EQ(p_of(comparison)->p, 1.0);
    EXPECT_EQ(test_words(comparison),
              "Cochran's Q on the same 5 participants, each answered alike at every level, p > "
              ".999");
    Study two_levels;
    for (int i = 0; i < 10; ++i) two_levels.add({true, true});
    const Analysis analysis = two_levels.analysed();
    const LevelDifference& difference = analysis.validity->by_level.at(0).differences.at(0);
    EXPECT_EQ(difference.difference, 0.0);
    // The exact upper limit of 0 in 10: 1 - .025^(1/10).
    EXPECT_NEAR(difference.interval.high, 1.0 - std::pow(.025, .1), 1e-12);
    EXPECT_NEAR(difference.interval.low, -difference.interval.high, 1e-15);
    EXPECT_EQ(analysis.verdicts.back().hypothesis, "H3");
    EXPECT_EQ(analysis.verdicts.back().conclusion, Conclusion::kUndecided);
    EXPECT_THAT(analysis.verdicts.back().sentence,
                AllOf(HasSubstr("McNemar's exact test on the same 10 participants, nobody changed "
                                "the answer, p > .999"),
                      HasSubstr("95 % interval -30.8 to +30.8"),
                      HasSubstr("leaves a difference of 15 points or more possible")));
}

/// Votes of None against Blizzard24: of 36 people everybody as `for_b` says, in order.
void add_condition(Study& study, const std::string& id, const std::string& scene,
                   const std::string& level, int for_b) {
    for (int who = 0; who < static_cast<int>(study.sessions.size()); ++who) {
        TrialRecord& trial = study.trials.emplace_back(tests::a_trial(who, 0));
        trial.condition = id;
        trial.scene = scene;
        trial.validity = level;
        trial.is_A_selected = who >= for_b;
    }
}

Study of_36() {
    Study study;
    for (int i = 0; i < 36; ++i) study.add({});
    return study;
}

TEST(H3, ADifferenceBetweenScenesIsNoEffectOfValidity) {
    Study study = of_36();
    add_condition(study, "II", "atrium-moderate", "moderate", 6);
    add_condition(study, "V", "atrium-high", "high", 6);
    add_condition(study, "VII", "figures-high", "high", 30);
    Tally tally = tally_trials("s", study.sessions, study.trials, "", Kind::kParticipant);
    name_views(tally, {{"atrium-moderate", "atrium"}, {"atrium-high", "atrium"}});
    const Analysis analysis = analyse(tally);
    ASSERT_EQ(analysis.validity->by_level.size(), 1U);
    EXPECT_EQ(analysis.validity->by_level[0].conditions, std::vector<std::string>({"II", "V"}));
    EXPECT_EQ(p_of(analysis.validity->by_level[0])->p, 1.0);
    EXPECT_TRUE(analysis.validity->across_scenes.empty());
    const Verdict& verdict = analysis.verdicts.back();
    EXPECT_EQ(verdict.p->p, 1.0);
    EXPECT_THAT(verdict.sentence,
                AllOf(HasSubstr("in atrium over moderate, high (II, V)"),
                      HasSubstr("VII has no partner at another level in the same scene.")));
}

TEST(H3, WhereNothingHasAPartnerIsNotTestedAndSaysWhy) {
    Study study = of_36();
    add_condition(study, "II", "atrium-moderate", "moderate", 6);
    add_condition(study, "VII", "figures-high", "high", 30);
    const Analysis other_scenes = study.analysed();
    EXPECT_EQ(other_scenes.verdicts.back().conclusion, Conclusion::kNotTested);
    EXPECT_EQ(other_scenes.verdicts.back().sentence,
              "H3: not tested. The study shows no two variants in the same scene at two levels of "
              "validity.");
    EXPECT_THAT(summary_text(other_scenes),
                HasSubstr("H3: not tested. The study shows no two variants in the same scene"));
    Study one_level = of_36();
    add_condition(one_level, "V", "atrium-high", "high", 6);
    EXPECT_EQ(one_level.analysed().verdicts.back().sentence,
              "H3: not tested. The study shows no two variants at two levels of validity.");
    EXPECT_EQ(one_level.analysed().verdicts[0].tests, 2U) << "what cannot be tested counts too";
}

TEST(H3, IsAskedOnlyWhereTheStudyAsksAndAStudysOwnLabelStaysItsOwn) {
    Study study = of_36();
    add_condition(study, "one", "hall", "moderate", 6);
    add_condition(study, "two", "hall", "high", 30);
    for (SessionRecord& session : study.sessions) session.study = "own-study";
    for (TrialRecord& trial : study.trials) trial.hypothesis = "H3";
    Tally tally = tally_trials("s", study.sessions, study.trials, "", Kind::kParticipant);
    const Analysis own = analyse(tally);
    EXPECT_FALSE(own.validity.has_value());
    ASSERT_EQ(own.verdicts.size(), 1U);
    EXPECT_EQ(own.verdicts[0].tests, 1U);
    EXPECT_THAT(own.verdicts[0].sentence, HasSubstr("H3: "));
    EXPECT_THAT(own.verdicts[0].sentence, HasSubstr("B was chosen in 36 of 72 votes"));
    tally.asks_validity = true;
    const Analysis asked = analyse(tally);
    ASSERT_EQ(asked.verdicts.size(), 2U);
    EXPECT_EQ(asked.verdicts[0].hypothesis, "H3");
    EXPECT_EQ(asked.verdicts[1].hypothesis, "validity");
    EXPECT_EQ(asked.verdicts[1].conclusion, Conclusion::kDiffers);
    EXPECT_THAT(asked.verdicts[1].sentence,
                HasSubstr("the effect differs with lighting, B more often at "));
    EXPECT_EQ(asked.verdicts[1].tests, 2U);
    const json report = json::parse(json_report(asked));
    EXPECT_EQ(report["validity_question"], "validity");
    EXPECT_EQ(report["hypotheses"]["H3"]["count_b"], 36);
    EXPECT_FALSE(report["hypotheses"]["H3"].contains("comparisons"));
}

TEST(OrderBiasReport, HasTheLogisticRegressionBesideTheExactTest) {
    const json bias = json::parse(json_report(nine_participants().analysed()))["order_bias"];
    EXPECT_EQ(bias["n"], 27);
    EXPECT_EQ(bias["logistic"]["conditions"], 3);
    EXPECT_GT(bias["logistic"]["standard_error"].get<double>(), 0.0);
    EXPECT_EQ(bias["logistic"]["df"], 1);
}

TEST(ScalesReport, GivesOneScaleForEachGroupThatPairsConnect) {
    const json report = json::parse(json_report(analyse(published_votes())));
    ASSERT_EQ(report["scales"].size(), 2U);
    EXPECT_EQ(report["scales"][0]["variants"], json({"None", "Crytek24", "Blizzard24"}));
    EXPECT_EQ(report["scales"][0]["bradley_terry"][0]["value"], 0.0);
    // A tree of pairs has closed forms: log(62/46), and log(62/46) - log(61/47).
    EXPECT_NEAR(report["scales"][0]["bradley_terry"][2]["value"].get<double>(),
                std::log(62.0 / 46.0), 1e-9);
    EXPECT_NEAR(report["scales"][0]["bradley_terry"][1]["value"].get<double>(),
                std::log(62.0 / 46.0) - std::log(61.0 / 47.0), 1e-9);
    EXPECT_EQ(report["scales"][1]["variants"], json({"Blizzard8", "RayMarching30"}));
    EXPECT_NEAR(report["scales"][1]["bradley_terry"][1]["standard_error"].get<double>(),
                std::sqrt(1.0 / 16.0 + 1.0 / 20.0), 1e-9);
    EXPECT_NEAR(report["conditions"][2]["bf10"].get<double>(), 3.091323, 1e-6);
    EXPECT_NEAR(report["conditions"][1]["probability_b_preferred"].get<double>(), .906129, 1e-6);
}

}  // namespace
}  // namespace obscura::analysis
