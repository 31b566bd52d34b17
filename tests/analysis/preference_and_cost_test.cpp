// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/preference_and_cost.h"

#include <gmock/gmock.h>

#include <cmath>

#include "analysis/counts_file.h"
#include "analysis/presentation/report.h"

namespace obscura::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ShownImage image(const std::string& condition, char side, const std::string& technique,
                 const std::string& variant, int samples, const std::string& validity) {
    ShownImage shown;
    shown.condition = condition;
    shown.side = side;
    shown.scene = "atrium";
    shown.camera = "nave";
    shown.validity = validity;
    shown.technique = technique;
    shown.variant = variant;
    shown.samples = samples;
    shown.denoise = "separable";
    return shown;
}

/// Two conditions of None against Blizzard24, at two levels.
ReportInput two_conditions(const std::string& rows) {
    ReportInput input;
    input.analysis = analyse(
        parse_counts("condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n"
                     "II,H1,moderate,None,Blizzard24,10,30\nV,H1,high,None,Blizzard24,10,30\n",
                     "votes.csv"));
    for (const auto& [id, level] : {std::pair{"II", "moderate"}, {"V", "high"}}) {
        input.images.push_back(image(id, 'A', "none", "None", 0, level));
        input.images.push_back(image(id, 'B', "blizzard", "Blizzard24", 24, level));
    }
    input.measurement = parse_measurement(
        "scene,camera,validity,technique,samples,ms_median,rmse,blur,device,fitted,published\n" +
            rows,
        "m.csv");
    return input;
}

TEST(PreferenceAndCost, JoinsByViewTechniqueAndSamples) {
    const ReportInput input = two_conditions(
        "atrium,nave,moderate,none,0,0,0.3,none,gpu,0,\n"
        "atrium,nave,moderate,blizzard,8,1,0.25,separable,gpu,0,\n"
        "atrium,nave,moderate,blizzard,24,2,0.1,separable,gpu,0,\n"
        "atrium,nave,high,none,0,0,0.3,none,gpu,0,\n"
        "atrium,nave,high,blizzard,24,2,0.1,separable,gpu,0,\n"
        "relic,nave,high,blizzard,24,9,0.9,separable,gpu,0,\n");
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    ASSERT_EQ(joined.pairs.size(), 2U);
    EXPECT_DOUBLE_EQ(*joined.pairs[0].error_difference, 0.1 - 0.3);
    EXPECT_DOUBLE_EQ(*joined.pairs[1].ms_difference, 2.0);
    EXPECT_TRUE(joined.not_joined.empty());
    EXPECT_EQ(joined.device, "gpu");
    // 75 % chose what is 0.2 nearer the truth, in both: that is the difference that 75 % notice.
    // One size of difference leaves nothing to fit a dependence to, by the curve's own rule.
    if (joined.by_error.overall.has_value()) {
        EXPECT_NEAR(*joined.by_error.overall->difference_75, -0.2, 1e-6);
    } else {
        EXPECT_FALSE(joined.by_error.overall.reason.empty());
    }
}

TEST(PreferenceAndCost, PrefersTheRowThatTheMeasurementSaysWasShown) {
    const ReportInput input = two_conditions(
        "atrium,nave,moderate,none,0,0,0.3,none,gpu,0,\n"
        "atrium,nave,moderate,blizzard,24,2,0.11,separable,gpu,0,\n"
        "atrium,nave,moderate,blizzard,24,2,0.12,none,gpu,0,III II\n"
        "atrium,nave,high,none,0,0,0.3,none,gpu,0,\n"
        "atrium,nave,high,blizzard,24,2,0.13,box4,gpu,0,VI\n"
        "atrium,nave,high,blizzard,24,2,0.14,separable,gpu,1,\n"
        "atrium,nave,high,blizzard,24,2,0.15,separable,gpu,0,\n");
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    ASSERT_EQ(joined.pairs.size(), 2U);
    EXPECT_EQ(*joined.pairs[0].b.rmse, 0.12) << "named for II; III is another condition";
    EXPECT_EQ(*joined.pairs[1].b.rmse, 0.15) << "neither another filter nor fitted";
}

TEST(PreferenceAndCost, KnowsAViewByTheStudysSceneAndASettingByItsSide) {
    ReportInput input = two_conditions("");
    for (ShownImage& image : input.images) {
        image.scene_id = image.condition == "II" ? "left" : "right";
        image.camera = "study";
        image.validity = "high";
        image.technique = "blizzard";
        image.samples = 24;
    }
    input.measurement = parse_measurement(
        "scene_id,scene,camera,validity,technique,samples,ms_median,rmse,published\n"
        "left,yard,study,high,blizzard,24,1,0.1,II a\n"
        "left,yard,study,high,blizzard,24,1,0.2,\"V a, II b\"\n"
        "right,yard,study,high,blizzard,24,1,0.3,V b\n"
        "right,yard,study,high,blizzard,24,1,0.4,V a\n",
        "m.csv");
    for (ConditionResult& result : input.analysis.conditions) result.condition.validity = "";
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    ASSERT_EQ(joined.pairs.size(), 2U);
    EXPECT_EQ(*joined.pairs[0].a.rmse, 0.1);
    EXPECT_EQ(*joined.pairs[0].b.rmse, 0.2);
    EXPECT_EQ(*joined.pairs[1].a.rmse, 0.4);
    EXPECT_EQ(*joined.pairs[1].b.rmse, 0.3);
}

TEST(PreferenceAndCost, NeverMixesDevices) {
    const ReportInput input = two_conditions(
        "atrium,nave,moderate,none,0,0,0.3,none,one,0,\n"
        "atrium,nave,moderate,blizzard,24,2,0.1,separable,two,0,\n"
        "atrium,nave,high,none,0,0,0.3,none,two,0,\n"
        "atrium,nave,high,blizzard,24,2,0.1,separable,two,0,\n");
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    EXPECT_EQ(joined.device, "two");
    ASSERT_EQ(joined.pairs.size(), 1U);
    EXPECT_EQ(joined.pairs[0].condition->condition.id, "V");
    EXPECT_THAT(joined.not_joined,
                ElementsAre(HasSubstr("II: no row of None on atrium, camera nave, moderate")));
}

TEST(PreferenceAndCost, SaysWhichConditionsCannotBeJoined) {
    ReportInput input = two_conditions("atrium,nave,moderate,none,0,0,0.3,none,gpu,0,\n");
    input.images.clear();
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    EXPECT_TRUE(joined.pairs.empty());
    ASSERT_EQ(joined.not_joined.size(), 2U);
    EXPECT_THAT(joined.not_joined[0], HasSubstr("it is not known how A (None) was rendered"));
    EXPECT_FALSE(joined.by_error.overall.has_value());
}

TEST(PreferenceAndCost, AValueThatWasNotMeasuredIsNoDifferenceOfZero) {
    const ReportInput input = two_conditions(
        "atrium,nave,moderate,none,0,,0.3,none,gpu,0,\n"
        "atrium,nave,moderate,blizzard,24,2,,separable,gpu,0,\n");
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    ASSERT_EQ(joined.pairs.size(), 1U);
    EXPECT_EQ(joined.pairs[0].error_difference.reason, "B: not measured");
    EXPECT_EQ(joined.pairs[0].ms_difference.reason, "A: not measured");
}

}  // namespace
}  // namespace obscura::analysis
