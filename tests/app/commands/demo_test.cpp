// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "analysis/store/store.h"
#include "app/kiosk/store_lock.h"
#include "tests/app/commands/run_program.h"
#include "tests/app/commands/study_text.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;

TEST(DemoCommand, ReplacesAnEmptyFileAndAnEarlierDemoButNoStoreOfAKioskThatRuns) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "tiny.toml", tiny_study("tiny"));
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
