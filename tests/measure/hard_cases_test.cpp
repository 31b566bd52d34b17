// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "renderer/base/error.h"
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

    HeadlessContext context_;
};

TEST_F(HardCases, NoneFailsOnAnyTechniqueWithoutAReason) {
    const std::vector<HardCaseResult> rows = run_hard_cases(small_options());
    std::set<std::string> names;
    for (const HardCaseResult& row : rows) {
        names.insert(row.name);
        EXPECT_NE(row.outcome, Outcome::kFails)
            << row.name << ", " << row.technique << ", " << row.quantity << ": expected "
            << row.expected << ", measured " << row.measured << ", tolerance " << row.tolerance;
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
    bench.begin(planes_case());
    bench.expect("crytek", "nothing", 1.0, std::nan(""), 1e9);
    bench.expect("crytek", "near", 1.0, 1.1, 0.2, "a reason that is not needed");
    bench.expect("crytek", "far", 1.0, 1.3, 0.2, "the reason");
    EXPECT_EQ(rows[0].outcome, Outcome::kFails);
    EXPECT_EQ(rows[1].outcome, Outcome::kHolds);
    EXPECT_EQ(rows[1].note, "");
    EXPECT_EQ(rows[2].outcome, Outcome::kByNature);
    EXPECT_EQ(rows[2].note, "the reason");
}

TEST_F(HardCases, ValuesOutsideZeroToOneAreFound) {
    std::vector<HardCaseResult> rows;
    const HardCaseOptions options = small_options();
    Bench bench(options, rows);
    bench.begin(odd_sizes_case());
    Shot shot{2, 1, {1.0F, 1.0F}, {std::nanf(""), 1.5F}, {0.5F, -0.1F}, 0.0};
    bench.expect_sound("crytek", "two pixels", shot);
    EXPECT_EQ(rows[0].measured, 3.0);
    EXPECT_EQ(rows[0].outcome, Outcome::kFails);
}

TEST_F(HardCases, AnUnknownTechniqueIsRefused) {
    HardCaseOptions options = small_options();
    options.techniques = {"crytec"};
    EXPECT_THROW((void)run_hard_cases(options), base::Error);
}

}  // namespace
}  // namespace obscura::renderer
