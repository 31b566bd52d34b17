// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Words follow from numbers: every sentence of every small table is read again and held against the
// votes that it is about.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "analysis/conclusions/analysis.h"
#include "analysis/counts_file.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/text_report.h"
#include "analysis/statistics/paired_difference.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kHalfOfLastDigit = .05 + 1e-9;  // of a number shown with one decimal

/// The numbers of the first match; empty where there is none.
std::vector<double> numbers_of(const std::string& text, const std::string& pattern) {
    std::smatch match;
    std::vector<double> numbers;
    if (!std::regex_search(text, match, std::regex(pattern))) return numbers;
    for (std::size_t i = 1; i < match.size(); ++i) numbers.push_back(std::stod(match[i].str()));
    return numbers;
}

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

/// A verdict on pooled votes, read again.
void check_share(const Verdict& verdict, const Votes& votes) {
    const std::string& text = verdict.sentence;
    const std::string said = fmt::format("{}: {}. ", verdict.hypothesis, verdict_words(verdict));
    EXPECT_TRUE(text.starts_with(said)) << text;
    if (votes.n() == 0) {
        EXPECT_EQ(verdict.conclusion, Conclusion::kNotTested) << text;
        EXPECT_FALSE(has(text, "%")) << text;
        return;
    }
    const auto counts = numbers_of(text, R"(chosen in (\d+) of (\d+) votes? \(([\d.]+) %\))");
    const auto ends = numbers_of(text, R"(95 % interval is ([\d.]+) to ([\d.]+) %)");
    ASSERT_EQ(counts.size(), 3U) << text;
    ASSERT_EQ(ends.size(), 2U) << text;
    EXPECT_EQ(counts[0], static_cast<double>(votes.b)) << text;
    EXPECT_EQ(counts[1], static_cast<double>(votes.n())) << text;
    EXPECT_NEAR(counts[2], 100.0 * counts[0] / counts[1], kHalfOfLastDigit) << text;
    EXPECT_LT(ends[0], ends[1]) << "an interval is no point: " << text;
    EXPECT_LE(ends[0], counts[2]) << text;
    EXPECT_GE(ends[1], counts[2]) << text;
    const auto inner = numbers_of(text, R"(90 % interval ([\d.]+) to ([\d.]+) %)");
    ASSERT_EQ(inner.size(), 2U) << text;
    EXPECT_LT(inner[0], inner[1]) << "an interval is no point: " << text;
    EXPECT_LE(inner[0], counts[2] + kHalfOfLastDigit) << text;
    EXPECT_GE(inner[1], counts[2] - kHalfOfLastDigit) << text;
    const bool reaches_a = inner[0] <= 35.0;
    const bool reaches_b = inner[1] >= 65.0;
    const bool is_within = !reaches_a && !reaches_b;
    ASSERT_TRUE(verdict.p_holm.has_value()) << text;
    const bool is_tested = *verdict.p_holm < kSignificance;
    EXPECT_EQ(has(text, "leaves a share of either image of 65 % or more possible"),
              !is_tested && reaches_a && reaches_b)
        << text;
    EXPECT_EQ(has(text, "leaves a share of B of 65 % or more possible"),
              !is_tested && !reaches_a && reaches_b)
        << text;
    EXPECT_EQ(has(text, "leaves a share of A of 65 % or more possible"),
              !is_tested && reaches_a && !reaches_b)
        << text;
    EXPECT_EQ(has(text, "excludes shares of 65 % or more of either image"), is_within) << text;
    EXPECT_EQ(verdict.conclusion == Conclusion::kBPreferred, is_tested && votes.b > votes.a);
    EXPECT_EQ(verdict.conclusion == Conclusion::kAPreferred, is_tested && votes.b < votes.a);
    EXPECT_EQ(verdict.conclusion == Conclusion::kEqual, !is_tested && is_within) << text;
    EXPECT_EQ(verdict.conclusion == Conclusion::kUndecided, !is_tested && !is_within) << text;
    EXPECT_EQ(has(text, "by less than the relevant 15 points"), is_tested && is_within) << text;
}

/// A verdict on validity over two levels, read again. `changed` of `n` participants did.
void check_difference(const Verdict& verdict, const Votes& changed, std::int64_t n) {
    const std::string& text = verdict.sentence;
    if (n == 0) {
        EXPECT_EQ(verdict.conclusion, Conclusion::kNotTested) << text;
        return;
    }
    EXPECT_NE(verdict.conclusion, Conclusion::kNotTested) << text;
    EXPECT_TRUE(has(text, fmt::format("on the same {} participant", n))) << text;
    if (changed.n() == 0) {
        EXPECT_TRUE(has(text, "nobody changed the answer, p > .999")) << text;
    } else {
        EXPECT_TRUE(
            has(text, fmt::format("{} changed from B to A, {} from A to B", changed.a, changed.b)))
            << text;
    }
    const bool is_tested = *verdict.p_holm < kSignificance;
    EXPECT_EQ(verdict.conclusion == Conclusion::kDiffers, is_tested) << text;
    EXPECT_EQ(has(text, "B more often at high than at moderate"),
              is_tested && changed.b > changed.a)
        << text;
    EXPECT_EQ(has(text, "B more often at moderate than at high"),
              is_tested && changed.b < changed.a)
        << text;
    const auto numbers = numbers_of(
        text,
        R"(changes by ([+-][\d.]+) points .* \(95 % interval ([+-][\d.]+) to ([+-][\d.]+), 90 % interval ([+-][\d.]+) to ([+-][\d.]+)\))");
    ASSERT_EQ(numbers.size(), 5U) << text;
    const double difference =
        100.0 * static_cast<double>(changed.b - changed.a) / static_cast<double>(n);
    EXPECT_NEAR(numbers[0], difference, kHalfOfLastDigit) << text;
    EXPECT_LT(numbers[1], numbers[2]) << "an interval is no point: " << text;
    EXPECT_LE(numbers[1], numbers[0] + kHalfOfLastDigit) << text;
    EXPECT_GE(numbers[2], numbers[0] - kHalfOfLastDigit) << text;
    EXPECT_LE(numbers[1], numbers[3]) << text;
    EXPECT_GE(numbers[2], numbers[4]) << text;
    const bool reaches = std::max(-numbers[3], numbers[4]) >= 15.0;
    EXPECT_EQ(has(text, "leaves a difference of 15 points or more possible"), reaches) << text;
    EXPECT_EQ(has(text, "excludes a difference of 15 points or more"), !reaches) << text;
    EXPECT_EQ(verdict.conclusion == Conclusion::kUndecided, !is_tested && reaches) << text;
    EXPECT_EQ(verdict.conclusion == Conclusion::kSame, !is_tested && !reaches) << text;
    EXPECT_EQ(has(text, "by less than the relevant 15 points"), is_tested && !reaches) << text;
    if (changed.n() == 0) {
        const double exact = 100.0 * (1.0 - std::pow(.025, 1.0 / static_cast<double>(n)));
        EXPECT_NEAR(numbers[2], exact, kHalfOfLastDigit) << text;
        EXPECT_NEAR(numbers[1], -exact, kHalfOfLastDigit) << text;
    }
}

void check_everything_said(const Analysis& analysis) {
    const std::string text = text_report(analysis) + json_report(analysis);
    for (const char* empty : {"nan", "100.0 to 100.0", " 0.0 to 0.0", "+0.0 to +0.0", " 1 votes",
                              " 1 participants", " 1 conditions", " 1 tests"}) {
        EXPECT_THAT(text, Not(HasSubstr(empty)));
    }
}

TEST(Sentences, OfCountsFollowFromTheirNumbers) {
    for (int n = 0; n <= 12; ++n) {
        for (int b = 0; b <= n; ++b) {
            const Analysis analysis = analyse(parse_counts(
                fmt::format("condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n"
                            "c,H1,low,None,Blizzard24,{},{}\n",
                            n - b, b),
                "c.csv"));
            ASSERT_EQ(analysis.verdicts.size(), 1U);
            check_share(analysis.verdicts[0], {n - b, b});
            check_everything_said(analysis);
        }
    }
}

/// One participant's answers at the two levels: 'A', 'B' or '-' for none.
struct Answers {
    char moderate;
    char high;
};

struct Crowd {
    Votes votes;
    Votes changed;
    std::int64_t both = 0;
    std::string text =
        "observer,study,scene,validity,hypothesis,condition,condition_A,condition_B,is_A_"
        "selected\n";

    void add(const Answers& answers, int how_many) {
        for (int i = 0; i < how_many; ++i) {
            ++people;
            answer("moderate", answers.moderate);
            answer("high", answers.high);
            if (answers.moderate == '-' || answers.high == '-') continue;
            ++both;
            if (answers.moderate == 'B' && answers.high == 'A') ++changed.a;
            if (answers.moderate == 'A' && answers.high == 'B') ++changed.b;
        }
    }

  private:
    void answer(const std::string& level, char choice) {
        if (choice == '-') return;
        ++(choice == 'B' ? votes.b : votes.a);
        text += fmt::format("p{},jakobsen2010,hall,{},H1,{},None,Blizzard24,{}\n", people, level,
                            level, choice == 'A' ? 1 : 0);
    }
    int people = 0;
};

void check(const Crowd& crowd) {
    if (crowd.votes.n() == 0) return;
    const Analysis analysis =
        analyse(tally_of(parse_trials(crowd.text, "t.csv"), "", Kind::kParticipant));
    ASSERT_EQ(analysis.verdicts.size(), 2U);
    check_share(analysis.verdicts[0], crowd.votes);
    check_everything_said(analysis);
    const Verdict& validity = analysis.verdicts[1];
    ASSERT_TRUE(validity.is_on_validity);
    if (crowd.both > 0) check_difference(validity, crowd.changed, crowd.both);
}

TEST(Sentences, OfAFewPeopleAtTwoLevelsFollowFromTheirNumbers) {
    for (const int people : {1, 2, 3, 4, 5, 9, 10, 12}) {
        const int step = people > 5 ? 2 : 1;
        for (int bb = 0; bb <= people; bb += step) {
            for (int ba = 0; bb + ba <= people; ba += step) {
                for (int ab = 0; bb + ba + ab <= people; ab += step) {
                    Crowd crowd;
                    crowd.add({'B', 'B'}, bb);
                    crowd.add({'B', 'A'}, ba);
                    crowd.add({'A', 'B'}, ab);
                    crowd.add({'A', 'A'}, people - bb - ba - ab);
                    check(crowd);
                    if (HasFailure()) return;
                }
            }
        }
    }
}

TEST(Sentences, OfPeopleWhoAnsweredOnlySomeFollowFromTheirNumbers) {
    for (const int people : {1, 2, 5, 11}) {
        for (const Answers some : {Answers{'B', '-'}, Answers{'-', 'A'}, Answers{'-', 'B'}}) {
            for (const Answers all : {Answers{'B', 'B'}, Answers{'A', 'B'}, Answers{'A', 'A'}}) {
                Crowd crowd;
                crowd.add(some, people);
                check(crowd);
                crowd.add(all, people);
                check(crowd);
            }
        }
    }
}

TEST(Sentences, OfManyWhoNeverChangedExcludeWhatTheyExclude) {
    for (const int people : {23, 24, 40, 100}) {
        Crowd crowd;
        crowd.add({'B', 'B'}, people / 2);
        crowd.add({'A', 'A'}, people - people / 2);
        check(crowd);
    }
}

/// The exact chance that the interval of n participants covers the difference.
double coverage(int n, double up, double down) {
    double covered = 0.0;
    for (int b = 0; b <= n; ++b) {
        for (int a = 0; a + b <= n; ++a) {
            const auto interval = paired_difference({a, b}, n);
            if (up - down < interval->low || up - down > interval->high) continue;
            const int rest = n - a - b;
            covered += std::exp(std::lgamma(n + 1.0) - std::lgamma(a + 1.0) - std::lgamma(b + 1.0) -
                                std::lgamma(rest + 1.0) + (b > 0 ? b * std::log(up) : 0.0) +
                                (a > 0 ? a * std::log(down) : 0.0) +
                                (rest > 0 ? rest * std::log(1.0 - up - down) : 0.0));
        }
    }
    return covered;
}

TEST(PairedDifference, CoversAsOftenAsItSays) {
    for (const int n : {5, 10, 36}) {
        for (const double up : {.01, .05, .15, .3, .45}) {
            for (const double down : {.01, .05, .15, .3, .45}) {
                EXPECT_GE(coverage(n, up, down), .945) << n << ' ' << up << ' ' << down;
            }
        }
    }
}

TEST(PairedDifference, TurnsRoundWithItsChangesAndRefusesWhatCannotBe) {
    const auto one = paired_difference({3, 8}, 36);
    const auto other = paired_difference({8, 3}, 36);
    EXPECT_NEAR(one->low, -other->high, 1e-15);
    EXPECT_NEAR(one->high, -other->low, 1e-15);
    EXPECT_FALSE(paired_difference({0, 0}, 0).has_value());
    EXPECT_THROW((void)paired_difference({3, 8}, 10), base::Error);
    EXPECT_THROW((void)paired_difference({0, 1}, 10, 1.0), base::Error);
}

}  // namespace
}  // namespace obscura::analysis
