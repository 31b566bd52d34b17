// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

#include "renderer/base/check.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/random.h"
#include "renderer/base/time_left.h"
#include "tests/support/temporary_folder.h"

namespace obscura::base {
namespace {

TEST(Hash, MeetsTheExamplesOfFips180) {
    EXPECT_EQ(sha256_hex("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Check, RefusesWhatIsOutsideAndNotANumber) {
    EXPECT_NO_THROW(check_range("here", "radius_m", 1.0, 0.0, 1.0));
    EXPECT_THROW(check_range("here", "radius_m", 1.1, 0.0, 1.0), Error);
    EXPECT_THROW(check_range("here", "radius_m", std::nan(""), 0.0, 1.0), Error);
    EXPECT_THROW(check_above("here", "radius_m", 0.0, 0.0, 1.0), Error);
}

TEST(Random, DrawsBelowAreUniform) {
    Random random(7);
    constexpr int kBins = 6;
    constexpr int kDraws = 60000;
    std::vector<int> counts(kBins, 0);
    for (int i = 0; i < kDraws; ++i) ++counts[random.below(kBins)];
    double chi_square = 0.0;
    for (const int count : counts)
        chi_square += std::pow(count - kDraws / kBins, 2) * kBins / kDraws;
    EXPECT_LT(chi_square, 20.515);  // the 0.999 quantile with 5 degrees of freedom
}

TEST(Files, AnUnfinishedWriteLeavesTheOldFileAndNothingElse) {
    namespace fs = std::filesystem;
    const tests::TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    write_file_atomically(folder / "a.txt", "old");
    fs::create_directory(folder / "b.txt");  // a rename onto a folder fails
    EXPECT_THROW(write_file_atomically(folder / "b.txt", "new"), Error);
    EXPECT_EQ(read_file(folder / "a.txt"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST(Files, AnUnwritableFolderIsRefusedWithItsOption) {
    try {
        require_writable_folder("/proc/no-such", "--out");
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadInput);
        EXPECT_NE(std::string(error.what()).find("--out"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("/proc/no-such"), std::string::npos);
    }
}

TEST(TimeLeft, IsTheMeanOfEachKindOfStepTimesThoseToCome) {
    TimeLeft left({2, 10});
    EXPECT_EQ(left.steps(), 12U);
    EXPECT_EQ(left.seconds(), 0.0);
    left.expect(1, 0.5);
    EXPECT_EQ(left.seconds(), 5.0);
    left.done(0, 30.0);
    EXPECT_EQ(left.seconds(), 35.0);
    left.done(1, 2.0);
    left.done(1, 4.0);
    EXPECT_EQ(left.seconds(), 30.0 + 8 * 3.0);
    left.leave_out(1, 5);
    EXPECT_EQ(left.seconds(), 30.0 + 3 * 3.0);
    left.leave_out(1, 50);
    EXPECT_EQ(left.steps(), 4U);
    EXPECT_EQ(left.steps_done(), 3U);
    EXPECT_EQ(left.seconds(), 30.0);
}

}  // namespace
}  // namespace obscura::base
