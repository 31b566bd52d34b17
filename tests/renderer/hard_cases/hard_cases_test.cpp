// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "renderer/base/error.h"
#include "renderer/denoise/denoise.h"
#include "renderer/gl/context.h"
#include "renderer/hard_cases/bench.h"

namespace obscura::renderer {
namespace {

class HardCases : public testing::Test {
  protected:
    static HardCaseOptions small_options() {
        HardCaseOptions options;
        options.size_px = 64;
        options.timing = false;
        options.vectors = 50'000;
        return options;
    }

    /// Of every case on every technique, measured once.
    static const std::vector<HardCaseResult>& all_rows() {
        static const std::vector<HardCaseResult> rows = run_hard_cases(small_options());
        return rows;
    }

    HeadlessContext context_;
};

TEST_F(HardCases, NoneFailsOnAnyTechniqueWithoutAReason) {
    std::set<std::string> names;
    for (const HardCaseResult& row : all_rows()) {
        names.insert(row.name);
        EXPECT_NE(row.outcome, Outcome::kFails)
            << row.name << ", " << row.technique << ", " << row.quantity << ": expected "
            << row.expected << ", measured " << row.measured << ", tolerance " << row.tolerance
            << "; " << row.note;
        if (row.outcome == Outcome::kByNature) {
            EXPECT_FALSE(row.note.empty()) << row.quantity;
        }
    }
    EXPECT_EQ(names.size(), 14U) << "a case gave no row";
}

TEST_F(HardCases, AValueThatIsNotANumberNeverHolds) {
    std::vector<HardCaseResult> rows;
    const HardCaseOptions options = small_options();
    Bench bench(options, rows);
    bench.expect("nothing", 1.0, std::nan(""), 1e9);
    EXPECT_EQ(rows[0].outcome, Outcome::kFails);
}

TEST_F(HardCases, OnlyAnImageThatIsAsDefinedIsExcusedByItsNature) {
    std::vector<HardCaseResult> rows;
    const HardCaseOptions options = small_options();
    Bench bench(options, rows);
    const auto outcome = [&](double measured, bool as_defined, const char* nature) {
        bench.expect("A", 1.0, {measured, 0.7, as_defined}, 0.2, nature);
        return rows.back().outcome;
    };
    EXPECT_EQ(outcome(1.1, true, "a reason that is not needed"), Outcome::kHolds);
    EXPECT_EQ(rows.back().note, "");
    EXPECT_EQ(outcome(0.7, true, "the reason"), Outcome::kByNature);
    EXPECT_EQ(rows.back().note, "the reason");
    EXPECT_EQ(outcome(0.7, true, ""), Outcome::kFails) << "no reason is known";
    EXPECT_EQ(outcome(0.3, false, "the reason"), Outcome::kFails) << "the shader is wrong";
    EXPECT_EQ(rows.back().definition, 0.7);
}

TEST_F(HardCases, HoldEachTechniqueAndFilterAgainstItsDefinitionInEveryCase) {
    std::set<std::string> held;
    for (const HardCaseResult& row : all_rows()) {
        if (row.against == Against::kDefinition) held.insert(row.technique + ' ' + row.quantity);
    }
    for (const Technique& technique : techniques()) {
        if (!technique.model) continue;
        for (const Denoise& filter : denoise_filters()) {
            const std::string of = filter.model ? filter.name + ": A" : "A";
            EXPECT_TRUE(held.contains(technique.name + ' ' + of +
                                      " at the pixel farthest from its definition"))
                << technique.name << ", " << of;
        }
    }
}

TEST_F(HardCases, ATimeThatIsTooBusyToTellIsNotDecidedAndTheWorkIsCounted) {
    HardCaseOptions options = small_options();
    options.cases = {5};
    options.techniques = {"raymarch"};
    options.timing = true;
    bool timed = false;
    bool counted = false;
    for (const HardCaseResult& row : run_hard_cases(options)) {
        if (row.quantity == "largest growth of the time when 1.6 times nearer") {
            timed = true;
            EXPECT_NE(row.outcome, Outcome::kFails) << row.measured;
            EXPECT_NE(row.outcome, Outcome::kByNature);
        }
        if (row.quantity.starts_with("look-ups of the depth buffer by a pixel")) {
            counted = true;
            EXPECT_EQ(row.note, "120 of 123 texture reads") << "30 directions of 4 steps";
        }
    }
    EXPECT_TRUE(timed);
    EXPECT_TRUE(counted);
}

TEST_F(HardCases, ValuesOutsideZeroToOneAreFound) {
    std::vector<HardCaseResult> rows;
    const HardCaseOptions options = small_options();
    Bench bench(options, rows);
    const Shot shot{.width = 2,
                    .height = 1,
                    .depth_m = {1.0F, 1.0F},
                    .accessibility = {std::nanf(""), 1.5F},
                    .denoised = {0.5F, -0.1F}};
    bench.expect_sound("two pixels", shot);
    EXPECT_EQ(rows[0].measured, 3.0);
    EXPECT_EQ(rows[0].outcome, Outcome::kFails);
}

TEST(Agreement, CountsPixelsBeyondWhatSinglePrecisionAllowsAndNamesTheWorst) {
    const std::vector<std::optional<Admitted>> admitted{
        Admitted{0.5, 0.4, 0.5}, Admitted{0.5, 0.5, 0.5}, std::nullopt, Admitted{1.0, 1.0, 1.0}};
    const auto of = [&](std::vector<float> measured) {
        return agreement_of(admitted, measured, 2, "image");
    };
    EXPECT_EQ(of({0.45F, 0.5F, 0.0F, 1.0F}).off, 0U);
    EXPECT_EQ(of({0.45F, 0.5F, 0.0F, 1.0F}).pixels, 3U);
    EXPECT_EQ(of({0.45F, 0.5F, 0.0F, 1.0F}).uncertain, 1U);
    EXPECT_EQ(of({0.55F, 0.5F, 0.0F, 1.0F}).off, 1U) << "only lower values are allowed";
    const Agreement worst = of({0.55F, 0.5F, 0.0F, 0.8F});
    EXPECT_EQ(worst.off, 2U);
    EXPECT_EQ(worst.worst.where, "image, pixel 1, 1");
    EXPECT_EQ(of({0.5F, std::nanf(""), 0.0F, 0.8F}).worst.where, "image, pixel 1, 0");
}

TEST_F(HardCases, AnUnknownTechniqueIsRefused) {
    HardCaseOptions options = small_options();
    options.techniques = {"crytec"};
    EXPECT_THROW((void)run_hard_cases(options), base::Error);
}

}  // namespace
}  // namespace obscura::renderer
