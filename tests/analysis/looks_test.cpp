// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Looking at answers more than once: boundaries, and what an analysis says of its look.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/conclusions/analysis.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/text_report.h"
#include "analysis/statistics/alpha_spending.h"
#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/exact_binomial.h"
#include "renderer/base/error.h"
#include "tests/analysis/records_for_test.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(AlphaSpending, OfThreeEqualLooksIsAsLanAndDeMetsHaveIt) {
    const auto looks = look_boundaries(Spending::kObrienFleming, .05, {12, 24, 36}, 36);
    ASSERT_EQ(looks.size(), 3U);
    EXPECT_NEAR(looks[0].z, 3.7103, 5e-5);
    EXPECT_NEAR(looks[1].z, 2.5114, 5e-5);
    EXPECT_NEAR(looks[2].z, 1.9930, 5e-5);
    EXPECT_NEAR(looks[0].spent, .0002, 5e-5);
    EXPECT_NEAR(looks[1].spent, .0121, 5e-5);
    EXPECT_NEAR(looks[2].spent, .0500, 1e-12);
}

TEST(AlphaSpending, OfPocockSpendsItsLogarithmAndEndsWithAllOfTheLevel) {
    const auto looks = look_boundaries(Spending::kPocock, .05, {50, 100}, 100);
    EXPECT_NEAR(looks[0].spent, .05 * std::log(1.0 + (std::exp(1.0) - 1.0) / 2.0), 1e-12);
    EXPECT_NEAR(looks[0].p, looks[0].spent, 1e-9) << "the first look's level is what it spends";
    EXPECT_NEAR(looks[1].spent, .05, 1e-12);
}

TEST(AlphaSpending, OfOneLookIsTheLevelAndThePItself) {
    for (const Spending spending : kSpendings) {
        EXPECT_NEAR(look_boundaries(spending, .05, {36}, 36)[0].z, 1.959964, 1e-6);
        EXPECT_NEAR(p_after_spending(.0123, spending, {36}, 36), .0123, 1e-8);
    }
}

TEST(AlphaSpending, PutsInPlaceOfAPTheLevelWhoseBoundaryItIs) {
    for (const Spending spending : {Spending::kObrienFleming, Spending::kPocock}) {
        for (const double level : {.001, .05, .4}) {
            const double p = look_boundaries(spending, level, {12, 24}, 36).back().p;
            EXPECT_NEAR(p_after_spending(p, spending, {12, 24}, 36), level, 1e-5 * level);
        }
        EXPECT_EQ(p_after_spending(1.0, spending, {12, 24}, 36), 1.0);
        EXPECT_EQ(p_after_spending(0.0, spending, {12, 24}, 36), 0.0);
        EXPECT_GE(p_after_spending(1e-300, spending, {12}, 36), 1e-300);
    }
}

TEST(AlphaSpending, NotDoneMakesErrorsAsArmitageMcPhersonAndRoweCountThem) {
    // Their table 2: .05 at each of 2, 3, 5 and 10 equal looks.
    EXPECT_NEAR(repeated_look_error(.05, {1}), .050, 1e-9);
    EXPECT_NEAR(repeated_look_error(.05, {1, 2}), .083, 5e-4);
    EXPECT_NEAR(repeated_look_error(.05, {1, 2, 3}), .107, 5e-4);
    EXPECT_NEAR(repeated_look_error(.05, {1, 2, 3, 4, 5}), .142, 5e-4);
    EXPECT_NEAR(repeated_look_error(.05, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}), .193, 5e-4);
}

TEST(AlphaSpending, RefusesLooksThatDoNotRise) {
    EXPECT_THROW((void)look_boundaries(Spending::kPocock, .05, {12, 12}, 36), base::Error);
    EXPECT_THROW((void)look_boundaries(Spending::kPocock, .05, {}, 36), base::Error);
}

std::string plan_with(const std::string& stopping) {
    return R"({"hypotheses":[{"id":"P","statement":"It looks better.","kind":"preference",)"
           R"("conditions":["C0"],"margin":0.15,"role":"primary"}])" +
           stopping + "}";
}

/// So many participants with one condition each, the first `for_b` of whom chose B.
Analysis looked_at(int participants, int for_b, const std::string& stopping,
                   std::vector<std::int64_t> before = {}) {
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
    for (int number = 0; number < participants; ++number) {
        SessionRecord& session = sessions.emplace_back(tests::a_session(number));
        session.study = "own";
        session.study_plan = plan_with(stopping);
        session.state = SessionState::kCompleted;
        TrialRecord& trial = trials.emplace_back(tests::a_trial(number, 0));
        trial.is_A_selected = number >= for_b;
        trial.response_first = trial.is_A_selected == (trial.first_shown == 'A');
    }
    Tally tally = tally_trials("s", sessions, trials, "", Kind::kParticipant);
    tally.looks_before = std::move(before);
    return analyse(std::move(tally));
}

constexpr const char* kThreeLooks =
    R"(,"stopping":{"looks":[12,24,36],"spending":"obrien-fleming"})";
constexpr const char* kOneLook = R"(,"stopping":{"looks":[36],"spending":"none"})";

TEST(Looks, AreKnownByTheirNumberOfParticipantsAndTheBoundaryIsApplied) {
    // 18 of 24: exact p .0227, which would count alone and does not at the second look.
    const Analysis second = looked_at(24, 18, kThreeLooks);
    ASSERT_TRUE(second.look.has_value()) << second.look.reason;
    EXPECT_EQ(second.look->looks.size(), 2U);
    EXPECT_TRUE(second.look->is_planned);
    EXPECT_NEAR(second.look->boundary.z, 2.5114, 5e-5);
    EXPECT_EQ(second.verdicts[0].conclusion, Conclusion::kUndecided);
    EXPECT_GT(*second.verdicts[0].p_holm, .05);
    EXPECT_THAT(text_report(second), HasSubstr("look 2"));
    EXPECT_THAT(second.verdicts[0].sentence, HasSubstr("after spending for this look and Holm"));
    // 19 of 24: p .0066.
    EXPECT_EQ(looked_at(24, 19, kThreeLooks).verdicts[0].conclusion, Conclusion::kBPreferred);
    // 18 of 24 again, where there is one look and nothing to spend for.
    EXPECT_EQ(looked_at(24, 18, R"(,"stopping":{"looks":[24]})").verdicts[0].conclusion,
              Conclusion::kBPreferred);
}

TEST(Looks, ThatWereNotPlannedAreOneMoreLookOfASpendingPlan) {
    const Analysis between = looked_at(30, 15, kThreeLooks);
    EXPECT_FALSE(between.look->is_planned);
    EXPECT_THAT(between.look->looks, testing::ElementsAre(12, 24, 30));
    EXPECT_THAT(between.look->words, HasSubstr("was not planned"));
    EXPECT_TRUE(between.look->is_interim);
}

TEST(Looks, BeforeTheLastOneConcludeNoEquality) {
    const std::string at_240 = R"(,"stopping":{"looks":[240,480],"spending":"pocock"})";
    const Analysis early = looked_at(240, 120, at_240);
    EXPECT_EQ(early.verdicts[0].conclusion, Conclusion::kUndecided);
    EXPECT_THAT(early.verdicts[0].sentence, HasSubstr("as long as participants are to come"));
    EXPECT_EQ(looked_at(480, 240, at_240).verdicts[0].conclusion, Conclusion::kEqual);
}

TEST(Looks, WithoutAPlanSaySoAndWhatTheyDoToFivePerCent) {
    const Analysis third = looked_at(36, 18, "", {12, 24});
    EXPECT_THAT(third.look->words, HasSubstr("looked at 3 times, with 12, 24 and 36"));
    // One vote each: the exact binomial test at each look, computed by going through all paths.
    EXPECT_NEAR(third.look->error, .0684, 3.0 * std::sqrt(.0684 * .93 / 2000));
    const Analysis planned_once = looked_at(36, 18, kOneLook, {12});
    EXPECT_THAT(planned_once.look->words, HasSubstr("planned one look, at 36"));
    EXPECT_THAT(planned_once.look->words, HasSubstr("not in 5 %"));
    const auto read = nlohmann::json::parse(json_report(third));
    EXPECT_EQ(read["look"]["number"], 3);
}

/// How often something is found in so many pooled conditions where nothing is, with looks at these
/// numbers of participants.
double simulated_error(int conditions, std::vector<std::int64_t> looks) {
    Tally tally;
    tally.study = "own";
    for (int i = 0; i < conditions; ++i) {
        ConditionVotes& condition = tally.conditions.emplace_back();
        condition.id = "C" + std::to_string(i);
        condition.hypothesis = "H1";
        condition.variant_a = "None";
        condition.variant_b = "Blizzard24";
    }
    tally.participants.resize(static_cast<std::size_t>(looks.back()));
    looks.pop_back();
    tally.looks_before = std::move(looks);
    return look_of(tally)->error;
}

/// The same of one condition by a test of its votes, over all ways in which they may come.
template <typename P>
double exact_error(const std::vector<std::int64_t>& looks, P p_of) {
    std::vector<double> chance{1.0};  // of so many votes for B without a look that found something
    double error = 0.0;
    for (const std::int64_t look : looks) {
        while (static_cast<std::int64_t>(chance.size()) <= look) {
            std::vector<double> next(chance.size() + 1);
            for (std::size_t b = 0; b < chance.size(); ++b) {
                next[b] += chance[b] / 2.0;
                next[b + 1] += chance[b] / 2.0;
            }
            chance.swap(next);
        }
        for (std::int64_t b = 0; b <= look; ++b) {
            if (p_of(b, look) >= .05) continue;
            error += chance[static_cast<std::size_t>(b)];
            chance[static_cast<std::size_t>(b)] = 0.0;
        }
    }
    return error;
}

TEST(Looks, AtEveryTwelfthOrTenthParticipantFindWhatIsNotThereTooOften) {
    const auto near = [](double share) { return 3.0 * std::sqrt(share * (1.0 - share) / 2000.0); };
    EXPECT_NEAR(simulated_error(3, {12, 24, 36}), .085, near(.085));
    const std::vector<std::int64_t> tens{10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120};
    EXPECT_NEAR(exact_error(tens,
                            [](std::int64_t b, std::int64_t n) {
                                return chi_square_equal_split({n - b, b})->p.p;
                            }),
                .19, .005);
    const double exact =
        exact_error(tens, [](std::int64_t b, std::int64_t n) { return exact_binomial(b, n)->p; });
    EXPECT_NEAR(simulated_error(1, tens), exact, near(exact));
}

TEST(Looks, ThatAreTheOnlyOneOfTheirPlanSayJustThat) {
    const Analysis only = looked_at(36, 18, kOneLook);
    EXPECT_THAT(only.look->words, HasSubstr("this is the one at 36."));
    EXPECT_THAT(only.look->words, Not(HasSubstr("times")));
    EXPECT_FALSE(looked_at(36, 18, "").look.has_value());
}

}  // namespace
}  // namespace obscura::analysis
