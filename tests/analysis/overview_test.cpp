// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/overview.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

namespace obscura::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;

OverviewRow row_of(const std::string& variant, const std::string& values, double ms, double rmse) {
    OverviewRow row;
    row.variant = variant;
    row.values = values;
    row.ms = ms;
    row.rmse = rmse;
    return row;
}

/// In the order: yardstick, on the front, beaten in both, without error, fitted yardstick.
std::vector<OverviewRow> some_rows() {
    std::vector<OverviewRow> rows{
        row_of("Blizzard24", "published", 40.0, 0.16), row_of("Gtao16", "fitted", 30.0, 0.09),
        row_of("Crytek24", "published", 50.0, 0.25), row_of("Unsharp", "published", 10.0, NAN),
        row_of("Blizzard24", "fitted", 20.0, 0.15)};
    finish_overview(rows);
    return rows;
}

TEST(Overview, RatiosAreToThePublishedYardstick) {
    const std::vector<OverviewRow> rows = some_rows();
    EXPECT_EQ(rows[0].ratio, 1.0);
    EXPECT_EQ(rows[1].ratio, 0.75);
    EXPECT_EQ(rows[4].ratio, 0.5);
}

TEST(Overview, WithoutAYardstickThereAreNoRatiosAndTheCellsAreEmpty) {
    std::vector<OverviewRow> rows{row_of("Gtao16", "fitted", 30.0, 0.09)};
    finish_overview(rows);
    EXPECT_TRUE(std::isnan(rows[0].ratio));
    EXPECT_THAT(overview_csv(rows), Not(HasSubstr("nan")));
    EXPECT_THAT(overview_text(rows), Not(HasSubstr("nan")));
    EXPECT_THAT(overview_chart(rows).script, HasSubstr("plot NaN"));
}

TEST(Overview, HardCasesThatHoldStandBesideAllAndThoseThatFailByNature) {
    std::vector<OverviewRow> rows = some_rows();
    rows[0].hard_held = 210;
    rows[0].hard_by_nature = 26;
    rows[0].hard_rows = 236;
    EXPECT_THAT(overview_text(rows), HasSubstr("210/236, 26 by nature"));
    EXPECT_THAT(overview_csv(rows), HasSubstr(",210,26,236,0.16,"));
    EXPECT_THAT(overview_csv(rows), HasSubstr(",,,,0.09,")) << "where none was run";
}

TEST(Overview, OnTheFrontIsWhatNoOtherRowBeatsAndNeverARowWithoutError) {
    const std::vector<OverviewRow> rows = some_rows();
    EXPECT_FALSE(rows[0].on_front);
    EXPECT_TRUE(rows[1].on_front);
    EXPECT_FALSE(rows[2].on_front);
    EXPECT_FALSE(rows[3].on_front);
    EXPECT_TRUE(rows[4].on_front);
}

TEST(Overview, ASecondLayersGeometryCountsForTheFront) {
    std::vector<OverviewRow> rows{row_of("Blizzard24", "published", 40.0, 0.16),
                                  row_of("Layered16", "fitted", 30.0, 0.16)};
    rows[1].layer_ms = 100.0;
    finish_overview(rows);
    EXPECT_TRUE(rows[0].on_front);
    EXPECT_FALSE(rows[1].on_front);
    EXPECT_EQ(rows[1].ratio, 0.75)
        << "the ratio is the technique's own, the layer stands beside it";
}

TEST(Overview, TheChartDrawsEveryRowThatHasAPlaceOnceAndSpansThem) {
    const Plot chart = overview_chart(some_rows());
    ASSERT_EQ(chart.data.size(), 1U);
    const std::string& data = chart.data[0].text;
    EXPECT_THAT(data, HasSubstr("0.75\t0.09"));
    EXPECT_THAT(chart.script, Not(HasSubstr("Unsharp"))) << "it has no error";
    EXPECT_THAT(chart.script, HasSubstr("set label 'Gtao16'"));
    EXPECT_THAT(chart.script, HasSubstr("logscale x"));
    // From 0.5 to 1.25 of the yardstick, and from 0.09 to 0.25.
    EXPECT_THAT(chart.script, HasSubstr("set xrange [0.41666"));
    EXPECT_THAT(chart.script, HasSubstr("set yrange [0.074"));
}

TEST(Overview, NoNameOfTheChartLiesOnTheLineOfTheFront) {
    std::vector<OverviewRow> rows(2);
    rows[0].variant = rows[0].technique = "cheap";
    rows[1].variant = rows[1].technique = "dear";
    rows[0].ratio = 1.0;
    rows[0].rmse = 0.2;
    rows[1].ratio = 4.0;
    rows[1].rmse = 0.1;
    for (OverviewRow& row : rows) row.on_front = true;
    const std::string script = overview_chart(rows).script;
    std::smatch place;
    ASSERT_TRUE(std::regex_search(script, place,
                                  std::regex("set label 'cheap' at screen [0-9.]+,([0-9.]+)")));
    // Of the axis that spans .09 to .208; a name in 11 points is 18 of the picture's 600 pixels
    // high.
    const double line = 0.12 + 0.78 * (0.2 - 0.09) / (0.208 - 0.09);
    EXPECT_GT(std::abs(std::stod(place[1].str()) - line), 9.0 / 600.0);
}

}  // namespace
}  // namespace obscura::analysis
