// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "analysis/store/store.h"
#include "app/kiosk/store_lock.h"
#include "tests/app/commands/run_program.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;

constexpr const char* kDemoStudy = R"([study]
name = "tiny"
title = "Tiny"
question = "Which?"
instructions = "Look."
resolution = [64, 48]
order = "fixed"
seed = 7
[[scene]]
id = "stone"
source = "relic"
camera = "front"
validity = "low"
[[condition]]
id = "one"
scene = "stone"
hypothesis = "H1"
a = { technique = "none" }
b = { technique = "crytek", samples = 8 }
)";

TEST(DemoCommand, ReplacesAnEmptyFileAndAnEarlierDemoButNoStoreOfAKioskThatRuns) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "tiny.toml", kDemoStudy);
    const std::filesystem::path file = folder.path() / "out" / "responses.sqlite";
    const std::string url = "sqlite3://" + file.string();
    const auto demo = [&](int observers) {
        return run_program(folder,
                           "demo tiny.toml --out out --participants " + std::to_string(observers));
    };
    const auto sessions = [&] {
        return analysis::Store(url, analysis::Store::Access::kReadOnly).sessions().size();
    };
    base::write_file_atomically(file, "");
    const ProgramRun first = demo(2);
    ASSERT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(sessions(), 2U);
    {
        const kiosk::StoreLock kiosk(url);
        const ProgramRun refused = demo(1);
        EXPECT_EQ(refused.exit_code, 1);
        EXPECT_THAT(refused.err, HasSubstr("another kiosk"));
    }
    EXPECT_EQ(sessions(), 2U);
    const ProgramRun again = demo(1);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(sessions(), 1U);
    EXPECT_THAT(again.out, HasSubstr("The observer is simulated"));
}

}  // namespace
}  // namespace obscura::app
