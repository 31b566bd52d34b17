// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "analysis/presentation/report.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

using Files = std::vector<ReportFile>;

TEST(WriteReport, MakesTheFoldersThatNamesBeginWith) {
    const tests::TemporaryFolder folder;
    const fs::path out = folder / "out";
    write_report(Files{{"page.html", "1"}, {"plots/deep/a.svg", "2"}, {"plots/b.svg", "3"}}, out);
    EXPECT_EQ(base::read_file(out / "page.html"), "1");
    EXPECT_EQ(base::read_file(out / "plots" / "deep" / "a.svg"), "2");
    write_report(Files{{"plots/b.svg", "4"}}, out);
    EXPECT_EQ(base::read_file(out / "plots" / "b.svg"), "4");
    // What the later report does not have is gone with the earlier one.
    EXPECT_FALSE(fs::exists(out / "page.html"));
}

TEST(WriteReport, BringsBackWhatStoodThereWhenAFolderCannotBeMade) {
    const tests::TemporaryFolder folder;
    const fs::path out = folder / "out";
    base::write_file_atomically(out / "page.html", "earlier");
    base::write_file_atomically(out / "plots", "a file where a folder must be");
    EXPECT_THROW(
        write_report(
            Files{{"page.html", "new"}, {"thumbnails/a.jpg", "new"}, {"plots/a.svg", "new"}}, out),
        base::Error);
    EXPECT_EQ(base::read_file(out / "page.html"), "earlier");
    EXPECT_FALSE(fs::exists(out / "thumbnails"));
    EXPECT_TRUE(fs::is_regular_file(out / "plots"));
}

}  // namespace
}  // namespace obscura::analysis
