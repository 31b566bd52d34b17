// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/conclusions/analysis.h"
#include "analysis/counts_file.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/text_report.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kParticipantsHeader =
    "observer,session_id,trial_index,condition,hypothesis,validity,condition_A,condition_B,"
    "is_A_selected,first_shown,kind,expected,repeats,exclusion,response_time\n";

/// Twenty observers of two conditions; the last four fail their catch trial and answer fast. Each
/// repeats condition I: the first ten choose the same again.
std::string attentive_and_not(const std::string& rule) {
    std::string text = kParticipantsHeader;
    for (int who = 0; who < 20; ++who) {
        const bool careless = who >= 16;
        const std::string begin = fmt::format("o{},s{},", who, who);
        const std::string end = fmt::format(",\"{}\",{}\n", rule, careless ? 0.1 : 1.0 + who * .1);
        text += begin + fmt::format("0,I,H1,low,None,X24,{:d},A,participant,,", careless) + end;
        text += begin + fmt::format("1,II,H1,high,None,X24,{:d},B,participant,,", careless) + end;
        text += begin + fmt::format("2,K,,low,None,X24,{:d},A,catch,B,", careless) + end;
        text += begin +
                fmt::format("3,I2,H1,low,None,X24,{:d},A,participant,,I", careless != (who >= 10)) +
                end;
    }
    return text;
}

Analysis analysed(const std::string& text) {
    return analyse(tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant));
}

TEST(Attention, CountsCatchTrialsAndRepeatedAnswersThatAreNoVotes) {
    const Analysis analysis = analysed(attentive_and_not(""));
    EXPECT_EQ(analysis.conditions.size(), 2U);
    EXPECT_EQ(analysis.conditions[0].condition.votes.b, 16);
    EXPECT_EQ(analysis.attention->catch_trials.n, 20);
    EXPECT_EQ(analysis.attention->catch_trials.successes, 16);
    EXPECT_EQ(analysis.attention->repeats.n, 20);
    EXPECT_EQ(analysis.attention->repeats.successes, 10);
    // Nineteen others: 16 or 15 of them chose B, so that only the careless four differ.
    EXPECT_EQ(analysis.attention->participants[0].with_majority.successes, 2);
    EXPECT_EQ(analysis.attention->participants[19].with_majority.successes, 0);
    EXPECT_FALSE(analysis.exclusions.has_value());
    EXPECT_EQ(analysis.exclusions.reason, "the study has no rule");
}

TEST(Exclusions, AreReportedWithAndWithoutAndWhatTheyChange) {
    const Analysis analysis = analysed(
        attentive_and_not("{\"\"min_catch_correct\"\":0.8,\"\"min_response_time_s\"\":0.2}"));
    EXPECT_EQ(analysis.exclusions->left_out, 4);
    EXPECT_EQ(*analysis.tally.n_participants, 16);
    EXPECT_EQ(analysis.conditions[0].condition.votes.a, 0);
    EXPECT_EQ(analysis.exclusions->everybody->conditions[0].condition.votes.a, 4);
    ASSERT_EQ(analysis.attention->participants[19].left_out.size(), 2U);
    EXPECT_EQ(analysis.attention->participants[19].left_out[0],
              "0 of 1 catch trials correct, a share of 0 below 0.8");
    EXPECT_THAT(text_report(analysis),
                AllOf(HasSubstr("4 of 20 participants"), HasSubstr("With everybody:"),
                      HasSubstr("o19: 0 of 1 catch trials")));
    const json report = json::parse(json_report(analysis));
    EXPECT_EQ(report["n_participants"], 16);
    EXPECT_EQ(report["exclusions"]["everybody"]["n_participants"], 20);
    EXPECT_EQ(report["exclusions"]["rule"]["min_catch_correct"], .8);
}

TEST(Exclusions, OfNobodyAndOfEverybodyAreSaid) {
    const Analysis nobody = analysed(attentive_and_not("{\"\"min_catch_correct\"\":0}"));
    EXPECT_EQ(nobody.exclusions->left_out, 0);
    EXPECT_EQ(nobody.exclusions->everybody, nullptr);
    const Analysis all = analysed(attentive_and_not("{\"\"min_response_time_s\"\":100}"));
    EXPECT_EQ(all.exclusions->left_out, 20);
    EXPECT_EQ(all.verdicts[0].conclusion, Conclusion::kNotTested);
    EXPECT_THAT(text_report(all), AllOf(HasSubstr("no votes"), Not(HasSubstr("nan"))));
    EXPECT_THAT(json_report(all), Not(HasSubstr("nan")));
}

TEST(Exclusions, RefusesARuleThatIsNone) {
    for (const char* rule : {"{\"\"min_luck\"\":1}", "{\"\"min_catch_correct\"\":2}", "[1]", "{"}) {
        EXPECT_THROW((void)parse_trials(attentive_and_not(rule), "t.csv"), base::Error) << rule;
    }
}

TEST(ResponseTimes, AreOneForEachParticipant) {
    const Analysis analysis = analysed(attentive_and_not(""));
    const ResponseTimeSummary& all = analysis.response_times->overall;
    EXPECT_EQ(all.seconds.n, 20);
    EXPECT_NEAR(all.seconds.median, 1.55, 1e-12);  // of four times .1, then 1.0, 1.1 ... 2.5
    ASSERT_TRUE(all.median_interval.has_value());
    // P(Bin(20, 1/2) <= 5) = .0207: the sixth from either end.
    EXPECT_NEAR(all.median_interval->low, 1.1, 1e-12);
    EXPECT_NEAR(all.median_interval->high, 2.0, 1e-12);
    EXPECT_THAT(analysis.learning->time.reason, HasSubstr("three or more"));
}

TEST(Learning, FindsTheTrendThatIsThere) {
    std::string text = kParticipantsHeader;
    for (int who = 0; who < 12; ++who) {
        for (int i = 0; i < 6; ++i) {
            text += fmt::format("o{},s{},{},C{},,low,None,X24,{},A,participant,,,,{}\n", who, who,
                                i, (i + who) % 6, (who + i * i) % 3 == 0 ? 1 : 0, 5.0 - .25 * i);
        }
    }
    const Analysis analysis = analysed(text);
    EXPECT_NEAR(analysis.learning->time->slope_s, -.25, 1e-12);
    EXPECT_EQ(analysis.learning->time->participants, 12);
    EXPECT_TRUE(analysis.learning->choice.has_value()) << analysis.learning->choice.reason;
}

TEST(Verdicts, OfThePublishedVotesAreUndecided) {
    const Analysis analysis =
        analyse(read_counts(OBSCURA_SOURCE_DIR "/analysis/data/jakobsen2010.csv"));
    ASSERT_EQ(analysis.verdicts.size(), 4U);
    for (const Verdict& verdict : analysis.verdicts) {
        EXPECT_EQ(verdict.conclusion, Conclusion::kUndecided) << verdict.sentence;
        EXPECT_THAT(verdict.sentence, HasSubstr(": undecided. "));
    }
    EXPECT_THAT(analysis.verdicts[0].sentence,
                AllOf(HasSubstr("exact binomial test p = .471, each participant counted once"),
                      Not(HasSubstr("needed"))));
    EXPECT_THAT(analysis.verdicts[3].sentence,
                AllOf(HasSubstr("in Sponza over moderate, high (III, VI): Fisher's exact p = .149, "
                                "chi-square 2.829, df 1, p = .093"),
                      HasSubstr("p = .621"), Not(HasSubstr("p = .158")),
                      HasSubstr("I, IV and VII have no partner")));
    EXPECT_EQ(analysis.verdicts[0].tests, 4U);
    EXPECT_NEAR(*analysis.verdicts[3].p_holm, 4 * .148839, 1e-5) << "the smallest of four";
    EXPECT_EQ(*analysis.verdicts[0].p_holm, 1.0) << "the next, 3 * .470691";
    EXPECT_THAT(text_report(analysis), HasSubstr("Holm's correction for 7 tests: none."));
    EXPECT_EQ(analysis.power->n, 36);
    EXPECT_NEAR(analysis.power->shares[1].exact.power, .3563, 5e-5);
    EXPECT_NEAR(analysis.power->shares[1].chi_square.true_size, .065245, 1e-6);
}

/// `observers` with one vote on each of two conditions, `of_ten` of every ten for B.
Verdict verdict_on(int observers, int of_ten) {
    std::string text = kParticipantsHeader;
    for (int who = 0; who < observers; ++who) {
        for (int i = 0; i < 2; ++i) {
            text += fmt::format("o{},s{},{},C{},H1,low,None,X24,{},A,participant,,,,\n", who, who,
                                i, i, (who + 5 * i) % 10 < of_ten ? 0 : 1);
        }
    }
    return analysed(text).verdicts.at(0);
}

TEST(Verdicts, FollowTheirRule) {
    EXPECT_EQ(verdict_words(verdict_on(100, 7)), "B preferred over A");
    EXPECT_EQ(verdict_words(verdict_on(100, 3)), "A preferred over B");
    EXPECT_EQ(verdict_words(verdict_on(100, 6)),
              "B preferred over A by less than the relevant 15 points");
    EXPECT_EQ(verdict_words(verdict_on(100, 4)),
              "A preferred over B by less than the relevant 15 points");
    EXPECT_EQ(verdict_words(verdict_on(100, 5)), "practically equal (within 15 points)");
    EXPECT_EQ(verdict_words(verdict_on(8, 5)), "undecided");
    EXPECT_EQ(verdict_words(verdict_on(1, 9)), "undecided");
}

TEST(PooledInterval, OfTheSameAnswersIsTheSameAndOfParticipants) {
    const std::string text = attentive_and_not("");
    const Analysis one = analysed(text);
    EXPECT_EQ(json_report(one), json_report(analysed(text)));
    // Everyone's two votes are alike: 16 of 20 participants, not 32 of 40 votes.
    const Interval& bounds = one.hypotheses[0].interval->bounds;
    EXPECT_NEAR(bounds.low, .8 - 2.093024 * std::sqrt(.16 / 19.0), 1e-6);
    EXPECT_NEAR(bounds.high, .8 + 2.093024 * std::sqrt(.16 / 19.0), 1e-6);
}

}  // namespace
}  // namespace obscura::analysis
