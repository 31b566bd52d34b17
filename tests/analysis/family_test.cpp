// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The family of hypotheses that is concluded on, and where it comes from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/conclusions/analysis.h"
#include "analysis/presentation/json_report.h"
#include "analysis/published_votes.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"
#include "tests/analysis/records_for_test.h"
#include "tests/analysis/trials_text.h"

namespace obscura::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kPlan =
    R"({"hypotheses":[{"id":"P","statement":"It looks better.","kind":"preference",)"
    R"("conditions":["C0"],"margin":0.2,"role":"primary"},)"
    R"({"id":"R","statement":"Or here.","kind":"preference","conditions":["C2"],)"
    R"("margin":0.15,"role":"secondary"},)"
    R"({"id":"Q","statement":"Light matters.","kind":"interaction",)"
    R"("pairs":[["C0","C1"],["C0","C9"]],"margin":0.15,"role":"primary"}]})";

/// So many sessions of three conditions, C0 and C1 the same at two levels; everybody chose B.
StoreContents sessions(int count, const std::string& plan) {
    StoreContents contents;
    for (int number = 0; number < count; ++number) {
        SessionRecord& session = contents.sessions.emplace_back(tests::a_session(number));
        session.study = "own";
        session.study_plan = plan;
        session.state = SessionState::kCompleted;
        for (int index = 0; index < 3; ++index) {
            TrialRecord& trial = contents.trials.emplace_back(tests::a_trial(number, index));
            trial.validity = index == 1 ? "moderate" : "high";
            trial.scene = index == 1 ? "hall-moderate" : "hall-high";
        }
    }
    return contents;
}

Analysis analysed(const StoreContents& contents) {
    return analyse(tally_trials("s", contents.sessions, contents.trials, "", Kind::kParticipant));
}

std::vector<std::string> names_of(const Analysis& analysis) {
    std::vector<std::string> names;
    for (const Verdict& verdict : analysis.verdicts) names.push_back(verdict.hypothesis);
    return names;
}

TEST(TheFamily, IsTheOneThatTheSessionsCarryWhateverTheConditionsName) {
    const Analysis analysis = analysed(sessions(6, kPlan));
    EXPECT_EQ(analysis.family.origin, FamilyOrigin::kPlan);
    EXPECT_THAT(names_of(analysis), ElementsAre("P", "Q", "R"));
    const Verdict& preferred = analysis.verdicts[0];
    EXPECT_EQ(preferred.statement, "It looks better.");
    EXPECT_EQ(preferred.tests, 3U) << "P, and both pairs of Q, of which nobody answered C9";
    EXPECT_NEAR(preferred.p->p, 2.0 / 64.0, 1e-12);
    EXPECT_NEAR(*preferred.p_holm, 6.0 / 64.0, 1e-12);
    EXPECT_EQ(preferred.margin, 0.2);
    EXPECT_EQ(analysis.validity->by_level.size(), 1U);
    EXPECT_THAT(analysis.validity->by_level[0].conditions, ElementsAre("C1", "C0"));
}

TEST(TheFamily, HasNoPartForASecondaryHypothesisWhichStandsAlone) {
    const Analysis analysis = analysed(sessions(6, kPlan));
    const Verdict& secondary = analysis.verdicts[2];
    EXPECT_FALSE(secondary.is_primary);
    EXPECT_FALSE(secondary.p_holm.has_value());
    EXPECT_EQ(secondary.conclusion, Conclusion::kBPreferred) << "p = 2 / 64 alone";
    EXPECT_EQ(analysis.verdicts[0].conclusion, Conclusion::kUndecided) << "6 / 64 corrected";
    EXPECT_THAT(secondary.sentence, HasSubstr("secondary, not corrected"));
}

TEST(TheFamily, IsWhatConditionsNameWhereSessionsCarryNoneOrDifferentOnes) {
    EXPECT_THAT(names_of(analysed(sessions(6, ""))), ElementsAre("H1"));
    StoreContents contents = sessions(6, kPlan);
    contents.sessions.back().study_plan = "";
    const Analysis analysis = analysed(contents);
    EXPECT_THAT(names_of(analysis), ElementsAre("H1"));
    EXPECT_THAT(analysis.family.words, HasSubstr("different plans"));
}

TEST(TheFamily, ComesBackFromAnExportedTable) {
    const std::string text = tests::trials_text(sessions(6, kPlan));
    const Analysis analysis =
        analyse(tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant));
    EXPECT_EQ(analysis.family.hypotheses, analysed(sessions(6, kPlan)).family.hypotheses);
    std::string broken = text;
    broken.replace(broken.find("preference"), 10, "preferance");
    EXPECT_THAT([&] { (void)parse_trials(broken, "t.csv"); },
                testing::ThrowsMessage<base::Error>(HasSubstr("kind (preference or interaction)")));
}

TEST(TheFamily, OfThePublishedVotesIsH1H2WithoutIVAndBothPairsOfH3) {
    const Analysis analysis = analyse(published_votes());
    EXPECT_EQ(analysis.family.origin, FamilyOrigin::kBuiltIn);
    EXPECT_THAT(names_of(analysis), ElementsAre("H1", "H2", "H2-IV", "H3"));
    for (const Verdict& verdict : analysis.verdicts) EXPECT_EQ(verdict.tests, 4U);
    EXPECT_FALSE(analysis.verdicts[2].is_primary);
    const auto report = nlohmann::json::parse(json_report(analysis));
    EXPECT_EQ(report["hypotheses"]["H2-IV"]["role"], "secondary");
    EXPECT_EQ(report["hypotheses"]["H1"]["statement"],
              "Ambient occlusion raises perceived realism.");
}

}  // namespace
}  // namespace obscura::analysis
