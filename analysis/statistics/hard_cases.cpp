// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/hard_cases.h"

#include <cmath>
#include <numbers>

#include "analysis/statistics/bayes_factor.h"
#include "analysis/statistics/bradley_terry.h"
#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/clopper_pearson.h"
#include "analysis/statistics/cochran_q.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/fisher_exact.h"
#include "analysis/statistics/holm.h"
#include "analysis/statistics/mcnemar.h"
#include "analysis/statistics/order_bias.h"
#include "analysis/statistics/posterior.h"
#include "analysis/statistics/power.h"
#include "analysis/statistics/preference_curve.h"
#include "analysis/statistics/sign_flip.h"
#include "analysis/statistics/wilson.h"

namespace obscura::analysis {
namespace {

constexpr const char* kR = "R 4.2.2";
constexpr double kSixDigits = 1e-6;
constexpr double kExact = 0.0;

class Cases {
  public:
    void add(const char* name, const char* quantity, double expected, double measured,
             double tolerance, const char* note) {
        const bool holds = std::isfinite(measured) && std::abs(measured - expected) <= tolerance;
        list_.push_back({name, quantity, expected, measured, tolerance, holds, note});
    }
    /// That a statistic gives a reason instead of a number.
    template <typename T>
    void add_reason(const char* name, const Possible<T>& value, const char* note) {
        const bool said = !value.has_value() && !value.reason.empty();
        add(name, "says why there is no value", 1.0, said ? 1.0 : 0.0, kExact, note);
    }
    std::vector<StatisticsCase> take() { return std::move(list_); }

  private:
    std::vector<StatisticsCase> list_;
};

void add_table_4(Cases& cases) {
    const char* const note = "R 4.2.2 on Table 4 of Jakobsen 2010";
    const Votes votes{11, 25};
    cases.add("11:25", "chi-square", 5.444444, chi_square_equal_split(votes)->statistic, kSixDigits,
              note);
    cases.add("11:25", "p", .019631, chi_square_equal_split(votes)->p.p, kSixDigits, note);
    cases.add("11:25", "exact p", .028817, exact_binomial(25, 36)->p, kSixDigits, note);
    cases.add("11:25", "Wilson low", .531437, wilson(25, 36)->low, kSixDigits, note);
    cases.add("11:25", "Wilson high", .819955, wilson(25, 36)->high, kSixDigits, note);
    cases.add("18:18", "p", 1.0, chi_square_equal_split({18, 18})->p.p, kExact, "a tie");
    cases.add("18:18", "exact p", 1.0, exact_binomial(18, 36)->p, kExact, "a tie");
    const std::vector<Votes> levels{{18, 18}, {11, 25}, {18, 18}};
    cases.add("H3 from counts", "p", .157894, chi_square_homogeneity(levels)->p.p, kSixDigits, kR);
    cases.add("H3, atrium", "p", .092565, chi_square_homogeneity({{11, 25}, {18, 18}})->p.p,
              kSixDigits, kR);
    cases.add("H3, atrium", "Fisher p", .148839, fisher_exact({11, 25}, {18, 18})->p, kSixDigits,
              kR);
    cases.add("seven tests", "smallest Holm p", .137415,
              holm({1, .1824224, .0196307, .5049851, .0196307, 1, .3173105})[2], kSixDigits, kR);
}

void add_anchors(Cases& cases) {
    cases.add("60 of 100", "exact p", .056888, exact_binomial(60, 100)->p, kSixDigits, kR);
    cases.add("682 of 925 against 3/4", "exact p", .382493, exact_binomial(682, 925, .75)->p, 2e-6,
              "R 4.2.2; rational arithmetic gives .3824916");
    cases.add("0 of 36", "Clopper-Pearson high", .09739376, clopper_pearson(0, 36)->high, 1e-8, kR);
    cases.add("0 of 36", "Clopper-Pearson low", 0.0, clopper_pearson(0, 36)->low, kExact,
              "by definition");
    cases.add("19 of 38", "Wilson low", .348499, wilson(19, 38)->low, kSixDigits, kR);
    cases.add("22 of 36", "P(share > .5)", .906129, posterior_flat(22, 36)->above_half.p,
              kSixDigits, kR);
    cases.add("25 of 36", "BF10", 3.091323, *bayes_factor(25, 36)->bf10, kSixDigits, kR);
    const std::vector<std::vector<bool>> rows{{1, 0, 1, 1}, {0, 1, 1, 1}, {1, 1, 1, 0},
                                              {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 1, 0},
                                              {0, 1, 0, 0}, {1, 1, 1, 1}, {0, 1, 0, 0}};
    cases.add("nine participants, four conditions", "Cochran's Q", 4.2, cochran_q(rows)->statistic,
              1e-12, "W. G. Cochran 1950, by hand");
    cases.add("approval ratings", "McNemar", 17.3559, mcnemar({150, 86})->uncorrected.statistic,
              5e-5, "A. Agresti 1990, p. 350");
    cases.add("share .65, 80 % power", "participants", 97.0,
              static_cast<double>(*participants_needed(SplitTest::kExact, .65, .05, .8)), kExact,
              kR);
    cases.add("36 votes, chi-square", "true size", .065245,
              power_of(SplitTest::kChiSquare, 36, 25.0 / 36.0, .05).true_size, kSixDigits, kR);
    const std::vector<std::string> journals{"Biometrika", "Comm. Stat.", "JASA", "JRSS-B"};
    const auto scale = bradley_terry(journals, {{0, 1, 730, 33},
                                                {0, 2, 498, 320},
                                                {0, 3, 221, 284},
                                                {1, 2, 68, 813},
                                                {1, 3, 17, 276},
                                                {2, 3, 142, 325}});
    cases.add("journal citations", "JASA, log odds", -.479570, scale->values[2], kSixDigits,
              "S. M. Stigler 1994; BradleyTerry2");
}

void add_tails_and_sizes(Cases& cases) {
    cases.add("chi-square 2000, df 1", "log p", -1004.027,
              chi_square_tail(2000.0, 1).log10_p * std::numbers::ln10, 5e-4,
              "R 4.2.2: pchisq(2000, 1, lower = FALSE, log = TRUE)");
    cases.add("0 of 36", "exact p", 2.910383e-11, exact_binomial(0, 36)->p, 1e-17, kR);
    cases.add("0 of 10000", "log10 exact p", -9999.0 * std::log10(2.0),
              exact_binomial(0, 10'000)->log10_p, 1e-8, "2 / 2^10000");
    const Votes billion{500'000'000, 500'100'000};
    cases.add("a billion votes", "chi-square", 9.999, chi_square_equal_split(billion)->statistic,
              5e-6, "100000^2 / 1000100000");
    cases.add("a billion votes", "p", .001566252, chi_square_equal_split(billion)->p.p, 1e-9, kR);
    cases.add("a billion votes", "exact p", .00156642252, exact_binomial(billion.b, billion.n())->p,
              1e-9, "mpmath 1.3, 40 digits");
    cases.add("one vote", "exact p", 1.0, exact_binomial(1, 1)->p, kExact, "by definition");
    cases.add("36 participants, one vote each", "flipped signs, p", .028817,
              sign_flip([] {
                  std::vector<std::int64_t> differences(36, 1);
                  std::fill_n(differences.begin(), 11, -1);
                  return differences;
              }())
                  ->p.p,
              kSixDigits, "the exact binomial test, R 4.2.2");
}

void add_reasons(Cases& cases) {
    cases.add_reason("no votes", chi_square_equal_split({0, 0}), "no NaN");
    cases.add_reason("no votes", wilson(0, 0), "no NaN");
    cases.add_reason("all votes for one side in both rows",
                     chi_square_homogeneity({{0, 5}, {0, 6}}), "an empty column");
    cases.add_reason("one always chosen over the other", bradley_terry({"x", "y"}, {{0, 1, 5, 0}}),
                     "L. R. Ford 1957: separation");
    cases.add_reason("order separates the votes", order_bias({{{0, 5}, {3, 2}}}), "one zero cell");
    cases.add_reason("nobody changed the answer", mcnemar({0, 0}), "no discordant pair");
    cases.add_reason(
        "every vote for the smaller error",
        preference_curve({{"I", "low", 1.0, {9, 0}}, {"II", "low", -2.0, {0, 9}}}).overall,
        "separation");
    cases.add_reason(
        "pairs that do not differ",
        preference_curve({{"I", "low", 0.0, {9, 3}}, {"II", "low", 0.0, {4, 9}}}).overall,
        "a constant predictor");
}

}  // namespace

std::vector<StatisticsCase> statistics_hard_cases() {
    Cases cases;
    add_table_4(cases);
    add_anchors(cases);
    add_tails_and_sizes(cases);
    add_reasons(cases);
    return cases.take();
}

}  // namespace obscura::analysis
