// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "analysis/fit/minimise.h"
#include "analysis/image_error/final_image_error.h"
#include "analysis/measurement/order_of_techniques.h"
#include "analysis/measurement/pareto.h"
#include "analysis/measurement/report.h"
#include "analysis/statistics/quantile.h"
#include "analysis/table/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/random.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

const std::vector<std::uint8_t> kAll(4, 1);

TEST(AccessibilityErrors, AreThoseOfAHandWorkedExample) {
    // Differences -.2, 0, .1, .3.
    const std::vector<float> measured{0.3F, 1.0F, 0.6F, 0.8F};
    const std::vector<float> truth{0.5F, 1.0F, 0.5F, 0.5F};
    const auto error = accessibility_error(measured, truth, kAll);
    ASSERT_TRUE(error.has_value());
    EXPECT_NEAR(error->rmse, std::sqrt(0.14 / 4.0), 1e-7);
    EXPECT_NEAR(error->bias, 0.05, 1e-7);
    EXPECT_NEAR(error->mae, 0.15, 1e-7);
    EXPECT_NEAR(error->p99, 0.2 + 0.97 * 0.1, 1e-6);
    EXPECT_NEAR(*error->psnr_db, -10.0 * std::log10(0.14 / 4.0), 1e-5);
    EXPECT_EQ(error->pixels, 4U);
    EXPECT_EQ(error->nonfinite, 0U);
}

TEST(AccessibilityErrors, CountWhatIsNotFiniteAndLeaveItOut) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<float> measured{nan, 0.75F, inf, -inf};
    const std::vector<float> truth(4, 0.5F);
    const auto error = accessibility_error(measured, truth, std::vector<std::uint8_t>{1, 1, 0, 1});
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->nonfinite, 3U);
    EXPECT_EQ(error->pixels, 1U);
    EXPECT_DOUBLE_EQ(error->rmse, 0.25);
}

TEST(AccessibilityErrors, HaveAReasonInPlaceOfANumberWhereThereIsNothingToCompare) {
    const std::vector<float> same(4, 0.5F);
    const auto none = accessibility_error(same, same, std::vector<std::uint8_t>(4, 0));
    EXPECT_FALSE(none.has_value());
    EXPECT_FALSE(none.reason.empty());
    EXPECT_FALSE(accessibility_error({}, {}, {}).has_value());
    const auto equal = accessibility_error(same, same, kAll);
    EXPECT_EQ(equal->rmse, 0.0);
    EXPECT_FALSE(equal->psnr_db.has_value());
    EXPECT_THROW((void)accessibility_error(same, {}, kAll), base::Error);
}

TEST(InteriorMask, LeavesOutAMarginAtEachSide) {
    const std::vector<std::uint8_t> mask = interior_mask(20, 10, 0.1);
    int inside = 0;
    for (const std::uint8_t value : mask) inside += value;
    EXPECT_EQ(inside, 16 * 8);
    EXPECT_EQ(mask.front(), 0);
    EXPECT_EQ(mask[5 * 20 + 10], 1);
    EXPECT_EQ(interior_mask(1, 1, 0.1), std::vector<std::uint8_t>{1});
}

TEST(FinalImageErrors, AreZeroForEqualImagesAndOneForBlackAgainstWhite) {
    const std::vector<std::uint8_t> black(3 * 16 * 16, 0);
    const std::vector<std::uint8_t> white(3 * 16 * 16, 255);
    const FinalImageError none = final_image_error(black, black, 16, 16);
    EXPECT_EQ(none.rmse, 0.0);
    EXPECT_EQ(none.yee_failed, 0.0);
    const FinalImageError most = final_image_error(black, white, 16, 16);
    EXPECT_DOUBLE_EQ(most.rmse, 1.0);
    EXPECT_DOUBLE_EQ(most.max, 1.0);
    EXPECT_THROW((void)final_image_error(black, white, 16, 15), base::Error);
}

TEST(FinalImageErrors, ThePerceptualMetricSeesAnInvertedPictureAndNotOneCodeValue) {
    // The metric weighs differences by the contrast around them, so the picture needs some.
    constexpr int kSide = 64;
    base::Random random(5);
    std::vector<std::uint8_t> picture;
    std::vector<std::uint8_t> inverted;
    std::vector<std::uint8_t> nearly;
    for (int i = 0; i < 3 * kSide * kSide; ++i) {
        const auto code = static_cast<std::uint8_t>(random.uniform(40.0, 215.0));
        picture.push_back(code);
        inverted.push_back(static_cast<std::uint8_t>(255 - code));
        nearly.push_back(static_cast<std::uint8_t>(code + i % 2));
    }
    EXPECT_GT(final_image_error(picture, inverted, kSide, kSide).yee_failed, 0.1);
    EXPECT_EQ(final_image_error(picture, nearly, kSide, kSide).yee_failed, 0.0);
}

TEST(Quantiles, InterpolateBetweenOrderStatistics) {
    const auto of = [](std::vector<double> sample, double share) {
        return quantile(sample, share);
    };
    EXPECT_DOUBLE_EQ(of({5.0}, 0.95), 5.0);
    EXPECT_DOUBLE_EQ(of({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(of({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
    EXPECT_DOUBLE_EQ(of({0.0, 10.0}, 0.95), 9.5);
    EXPECT_EQ(summary_of({}).median_ms, 0.0);
}

TEST(Quantiles, AreTheSameOfASampleInAnyOrder) {
    base::Random random(11);
    for (const std::size_t n : {1U, 2U, 3U, 10U, 101U}) {
        std::vector<double> sample;
        for (std::size_t i = 0; i < n; ++i) sample.push_back(random.uniform(-1.0, 1.0));
        std::vector<double> sorted = sample;
        std::sort(sorted.begin(), sorted.end());
        for (const double share : {0.0, 0.05, 0.25, 0.5, 0.77, 0.99, 1.0}) {
            EXPECT_EQ(quantile(sample, share), quantile_of_sorted(sorted, share)) << n;
        }
    }
}

TEST(ParetoFront, HoldsExactlyWhatNoOtherChoiceBeats) {
    base::Random random(3);
    std::vector<CostAndError> choices;
    for (int i = 0; i < 300; ++i) {
        choices.push_back({std::floor(random.uniform(0.0, 20.0)), random.uniform()});
    }
    choices.push_back({0.0, std::nan("")});
    const std::vector<CostAndError> front = pareto_front(choices);
    ASSERT_GT(front.size(), 2U);
    for (std::size_t i = 1; i < front.size(); ++i) {
        EXPECT_GT(front[i].cost, front[i - 1].cost);
        EXPECT_LT(front[i].error, front[i - 1].error);
    }
    std::size_t on_front = 0;
    for (const CostAndError& choice : choices) on_front += is_on_front(choice, choices) ? 1 : 0;
    EXPECT_EQ(on_front, front.size());
    EXPECT_TRUE(pareto_front({}).empty());
}

TEST(PowerLaws, FindTheExponentOfExactDataAndItsIntervalOfNoisyData) {
    const std::vector<double> x{1.0, 2.0, 4.0, 8.0, 16.0};
    std::vector<double> y;
    for (const double value : x) y.push_back(3.0 * std::pow(value, 1.25));
    const auto exact = power_law(x, y);
    ASSERT_TRUE(exact.has_value());
    EXPECT_NEAR(exact->exponent, 1.25, 1e-12);
    EXPECT_NEAR(exact->high - exact->low, 0.0, 1e-6);
    // R: confint(lm(log(y) ~ log(x)))
    const auto noisy = power_law(x, std::vector<double>{1.0, 2.5, 3.5, 9.0, 15.0});
    ASSERT_TRUE(noisy.has_value());
    EXPECT_LT(noisy->low, noisy->exponent);
    EXPECT_GT(noisy->high, noisy->exponent);
    EXPECT_FALSE(power_law(std::vector{1.0, 2.0}, std::vector{1.0, 2.0}).has_value());
    EXPECT_FALSE(power_law(std::vector{1.0, 1.0, 1.0}, std::vector{1.0, 2.0, 3.0}).has_value());
    EXPECT_FALSE(power_law(std::vector{1.0, 2.0, 3.0}, std::vector{1.0, 0.0, 3.0}).has_value());
}

TEST(Minimise, FindsTheMinimumOfAValleyAcrossScales) {
    const std::vector<Unknown> unknowns{{"radius", 0.01, 10.0, 2.0, true},
                                        {"bias", -1.0, 1.0, 0.9, false}};
    const auto valley = [](std::span<const double> at) {
        return std::pow(std::log(at[0] / 0.3), 2.0) + std::pow(at[1] + 0.25, 2.0);
    };
    const MinimiseOptions options{.starts = 3, .evaluations = 200, .tolerance = 1e-4, .seed = 5};
    const Minimum found = minimise(unknowns, valley, options);
    EXPECT_NEAR(found.values[0], 0.3, 0.01);
    EXPECT_NEAR(found.values[1], -0.25, 0.01);
    EXPECT_LT(found.smallest, found.at_start);
    EXPECT_EQ(minimise(unknowns, valley, options).values, found.values) << "not repeatable";
}

TEST(Minimise, ScoutsLeadItOffAPlainAndAStartAtAnEndIsNoHindrance) {
    const std::vector<Unknown> unknowns{{"x", 0.01, 10.0, 10.0, true}, {"y", 0.0, 1.0, 1.0, false}};
    const auto hole = [](std::span<const double> at) {
        const double far = std::pow(std::log(at[0] / 0.05), 2.0) + std::pow(at[1] - 0.4, 2.0);
        return std::min(1.0, 0.2 * far);  // flat around the start
    };
    MinimiseOptions options{.starts = 1, .evaluations = 60, .tolerance = 1e-4, .seed = 3};
    EXPECT_EQ(minimise(unknowns, hole, options).smallest, 1.0);
    options.scouts = 15;
    EXPECT_LT(minimise(unknowns, hole, options).smallest, 0.01);
}

TEST(Minimise, IsNeverWorseThanItsStartAndStandsWhatIsNotANumber) {
    const std::vector<Unknown> unknowns{{"x", 0.0, 1.0, 0.5, false}};
    const auto spike = [](std::span<const double> at) { return at[0] == 0.5 ? 1.0 : std::nan(""); };
    const Minimum found = minimise(unknowns, spike, {.starts = 2, .evaluations = 20});
    EXPECT_EQ(found.smallest, 1.0);
    EXPECT_EQ(found.values, std::vector<double>{0.5});
    EXPECT_EQ(minimise({}, [](std::span<const double>) { return 7.0; }).smallest, 7.0);
}

TEST(Minimise, PassesOnTheErrorOfItsFunctionAndRefusesRangesThatAreNone) {
    const auto broken = [](std::span<const double>) -> double {
        throw base::failure("the disk is full");
    };
    EXPECT_THROW((void)minimise({{"x", 0.0, 1.0, 0.5, false}}, broken), base::Error);
    const auto zero = [](std::span<const double>) { return 0.0; };
    EXPECT_THROW((void)minimise({{"x", 1.0, 1.0, 1.0, false}}, zero), base::Error);
    EXPECT_THROW((void)minimise({{"x", 0.0, 1.0, 0.5, true}}, zero), base::Error);
    EXPECT_THROW((void)minimise({{"x", 0.0, 1.0, std::nan(""), false}}, zero), base::Error);
}

MeasurementRow row_of(const std::string& technique, const std::string& variant, int samples,
                      double ms, double rmse) {
    MeasurementRow row;
    row.scene_id = "atrium-high";
    row.scene = "atrium";
    row.camera = "nave";
    row.validity = "high";
    row.technique = technique;
    row.variant = variant;
    row.samples = samples;
    row.denoise = "separable";
    row.depth_format = "r32f";
    row.noise = "tile4x4";
    row.width = 64;
    row.height = 36;
    row.device = "a \"device\", 2 cores";
    row.timer = "clock";
    row.published = "III a";
    row.cost = {ms, ms, ms};
    AccessibilityError error;
    error.rmse = rmse;
    error.pixels = 10;
    row.error = error;
    return row;
}

std::vector<MeasurementRow> three_rows() {
    return {row_of("crytek", "Crytek24", 24, 1.0, 0.2),
            row_of("blizzard", "Blizzard24", 24, 2.0, 0.1),
            row_of("raymarch", "RayMarching30", 30, 3.0, 0.15)};
}

TEST(MeasurementRows, HaveTheColumnsThatOthersRelyOnFirst) {
    const auto records = parse_csv(measurement_csv(three_rows()), "measure.csv");
    ASSERT_EQ(records.size(), 4U);
    const std::vector<std::string> fixed{
        "scene_id", "scene",        "camera",    "validity",       "technique", "samples", "blur",
        "ao_scale", "depth_format", "noise",     "width",          "height",    "device",  "fitted",
        "ms_min",   "ms_median",    "ms_p95",    "fetches_per_px", "rmse",      "bias",    "mae",
        "p99",      "psnr_db",      "nonfinite", "on_front"};
    const auto& header = records[0].fields;
    ASSERT_GE(header.size(), fixed.size());
    EXPECT_TRUE(std::equal(fixed.begin(), fixed.end(), header.begin()));
    EXPECT_EQ(records[1].fields[12], "a \"device\", 2 cores");
    EXPECT_EQ(records[1].fields[18], "0.2");
}

TEST(MeasurementRows, WithoutAnErrorHaveEmptyCellsAndAReason) {
    std::vector<MeasurementRow> rows{three_rows()[0]};
    rows[0].error = Possible<AccessibilityError>::none("nothing is to be seen");
    const auto records = parse_csv(measurement_csv(rows), "measure.csv");
    EXPECT_EQ(records[1].fields[18], "");
    const auto read = nlohmann::json::parse(measurement_json(rows));
    EXPECT_TRUE(read[0]["rmse"].is_null());
    EXPECT_EQ(read[0]["rmse_reason"], "nothing is to be seen");
}

TEST(MeasurementRows, AreOnTheFrontOfTheirOwnViewOnly) {
    std::vector<MeasurementRow> rows = three_rows();
    MeasurementRow other = row_of("crytek", "Crytek24", 24, 100.0, 0.9);
    other.scene = "relic";
    rows.push_back(other);
    mark_front(rows);
    EXPECT_TRUE(rows[0].on_front);
    EXPECT_TRUE(rows[1].on_front);
    EXPECT_FALSE(rows[2].on_front);
    EXPECT_TRUE(rows[3].on_front);
}

TEST(OrderOfTechniques, IsReadFromTheErrorsAndSaidPlainly) {
    std::vector<MeasurementRow> rows = three_rows();
    auto orders = orders_of_techniques(rows, "separable");
    ASSERT_EQ(orders.size(), 1U);
    EXPECT_FALSE(orders[0].as_assumed);
    EXPECT_THAT(orders[0].by_error,
                testing::ElementsAre("Blizzard24", "RayMarching30", "Crytek24"));
    EXPECT_THAT(order_in_a_sentence(orders), HasSubstr("holds in 0 of 1 view as published"));
    EXPECT_THAT(order_in_a_sentence(orders), HasSubstr("was not measured when each is fitted"));
    AccessibilityError better;
    better.rmse = 0.05;
    rows[2].error = better;
    orders = orders_of_techniques(rows, "separable");
    EXPECT_TRUE(orders[0].as_assumed);
    rows.pop_back();
    EXPECT_TRUE(orders_of_techniques(rows, "separable").empty());
}

TEST(HardCaseTables, CountAndQuoteEveryRow) {
    const std::vector<HardCaseRow> rows{
        {"1 planes", "crytek", "A, tilted", 1.0, 0.75, 0.005, Holds::kByNature, "its \"nature\"",
         HeldAgainst::kTruth, 0.5},
        {"1 planes", "crytek", "A", 0.5, 0.5, 0.0, Holds::kYes, "", HeldAgainst::kDefinition, 0.5},
        {"5 close-up", "crytek", "time", 1.0, 3.0, 1.0, Holds::kUndecided, ""},
        {"6 not a number", "blizzard", "A", 0.0, std::nan(""), 0.0, Holds::kNo, ""},
        {"8 background", "blizzard", "A", 1.0, 1.0, 0.0, Holds::kYes, ""}};
    const auto records = parse_csv(hard_cases_csv(rows), "hard-cases.csv");
    EXPECT_THAT(
        records[0].fields,
        testing::ElementsAre("case", "technique", "quantity", "expected", "measured", "tolerance",
                             "holds", "note", "against", "definition", "by_nature", "numerical"));
    EXPECT_EQ(records[1].fields[6], "by nature");
    EXPECT_THAT(std::vector(records[1].fields.begin() + 8, records[1].fields.end()),
                testing::ElementsAre("truth", "0.5", "0.5", "-0.25"));
    EXPECT_EQ(records[2].fields[8], "definition");
    EXPECT_EQ(records[3].fields[6], "not decided");
    EXPECT_EQ(records[3].fields[9], "");
    EXPECT_EQ(records[4].fields[4], "nan");
    const HardCaseCount count = count_of(rows);
    EXPECT_EQ(count.yes, 2U);
    EXPECT_EQ(count.undecided, 1U);
    EXPECT_EQ(count.numerical, 1U);
    EXPECT_EQ(count.numerical_holding, 1U);
    EXPECT_EQ(count.by_nature, 1U);
    EXPECT_EQ(count.no, 1U);
}

TEST(Plots, HoldTimesAgainstBlizzard24AndMarkTheSettingsThatTheStudyShows) {
    const Plot plot = error_over_time(three_rows(), "separable");
    EXPECT_THAT(plot.script, HasSubstr("of Blizzard24's"));
    EXPECT_THAT(plot.data[0].text, HasSubstr("\n1\t")) << "its own time over itself";
    std::vector<MeasurementRow> without = three_rows();
    std::erase_if(without, [](const auto& row) { return row.technique == "blizzard"; });
    EXPECT_THAT(error_over_time(without, "separable").script, HasSubstr("(ms)"));
    EXPECT_THAT(plot.data[0].text, HasSubstr("RayMarching30"));
    EXPECT_THAT(plot.data[0].text, HasSubstr("# front"));
    const ErrorMap wrong{"map", "map", 2, 2, {0.0F}, 0.5};
    EXPECT_THROW((void)error_map(wrong), base::Error);
}

TEST(Reports, HoldEveryTableAndOnePageThatStandsAlone) {
    const tests::TemporaryFolder folder;
    MeasurementReport report;
    report.title = "Speed against error";
    report.device = "a device";
    report.denoise = "separable";
    report.asks_order = true;
    report.rows = three_rows();
    report.hard_cases = {{"1 planes", "crytek", "A", 1.0, 1.0, 0.0, Holds::kYes, ""}};
    report.maps = {{"error-map", "a map", 3, 2, {0.0F, 0.1F, -0.1F, 0.2F, NAN, 0.0F}, 0.5}};
    (void)write_report(report, folder.path());
    for (const char* file : {"measure.csv", "measure.json", "hard-cases.csv", "measure.html",
                             "error-map.f32", "error-map.gnuplot"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
    }
    const std::string page = base::read_file(folder / "measure.html");
    EXPECT_THAT(page, HasSubstr("holds in 0 of 1 view as published"));
    EXPECT_THAT(page, testing::Not(HasSubstr("<script")));
    EXPECT_THAT(report_text(report), HasSubstr("1 hard cases: 1 hold"));
}

}  // namespace
}  // namespace obscura::analysis
