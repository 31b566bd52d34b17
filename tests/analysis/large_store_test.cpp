// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// A store so large that its pages are checked beside the reading: what is damaged is refused as in
// a small one, only later.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "analysis/export/export.h"
#include "analysis/store/columns.h"
#include "analysis/store/database.h"
#include "analysis/store/rows.h"
#include "analysis/store/store.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LargeStore : public testing::Test {
  protected:
    void SetUp() override {
        tests::add_completed(*std::make_unique<Store>(url, Store::Access::kThrowaway), 0);
        Database database(url, false);
        database.execute(fmt::format(
            "INSERT INTO events (time_utc, name, detail) VALUES ('{}', 'note', printf('%.*c', "
            "70000000, 'x'))",
            tests::kUtc));
    }

    /// What reading the trials says; empty: they were read.
    [[nodiscard]] std::string reading() const {
        try {
            Store store(url, Store::Access::kReadOnly);
            EXPECT_EQ(store.trials().size(), 7U);
            return "";
        } catch (const base::Error& error) {
            return error.what();
        }
    }

    tests::TemporaryFolder folder;
    fs::path file = folder / "responses.sqlite";
    std::string url = "sqlite3://" + file.string();
};

TEST_F(LargeStore, IsReadWhereItIsWhole) { EXPECT_EQ(reading(), ""); }

TEST_F(LargeStore, WhoseLastPageIsMissingCannotBeRead) {
    fs::resize_file(file, fs::file_size(file) - 4096);
    EXPECT_THAT(reading(), HasSubstr("is damaged"));
}

TEST_F(LargeStore, WithAPageOfItsTextGivenTwiceCannotBeRead) {
    // The chain of the long text's pages: each begins with the number of the next (big endian).
    std::string bytes = base::read_file(file);
    const std::size_t middle = bytes.size() / 4096 / 2 * 4096;
    bytes.replace(middle, 4, bytes.substr(middle + 4096, 4));
    base::write_file_atomically(file, bytes);
    EXPECT_THAT(reading(), HasSubstr("is damaged")) << "no trial lies there";
}

TEST_F(LargeStore, ThatIsDamagedLeavesNoExport) {
    std::string bytes = base::read_file(file);
    const std::size_t middle = bytes.size() / 4096 / 2 * 4096;
    bytes.replace(middle, 4, bytes.substr(middle + 4096, 4));
    base::write_file_atomically(file, bytes);
    Store store(url, Store::Access::kReadOnly);
    ExportOptions options;
    options.folder = folder / "export";
    bool threw = false;
    try {
        store.of_one_moment([&] {
            try {
                (void)export_store(store, options);
            } catch (const base::Error&) {
                threw = true;
                throw;
            }
        });
    } catch (const base::Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("is damaged"));
    }
    EXPECT_TRUE(threw) << "found only when the export had been kept";
    EXPECT_TRUE(fs::is_empty(options.folder)) << "no file was to be kept";
}

/// What the store's reader says of trials that hold the value.
std::string reading_with(soci::session& session, const std::string& value) {
    session << "SAVEPOINT whole";
    session << "UPDATE trials SET " + value;
    std::string said;
    try {
        (void)select(session, trials_table(), "ORDER BY entry DESC");
    } catch (const base::Error& error) {
        said = error.what();
    }
    session << "ROLLBACK TO whole";
    return said;
}

TEST(StoreColumns, DoNotGiveAValueThatNoneCanBe) {
    const tests::TemporaryFolder folder;
    const std::string file = (folder / "responses.sqlite").string();
    tests::add_completed(*std::make_unique<Store>("sqlite3://" + file, Store::Access::kThrowaway),
                         0);
    soci::session session(soci::sqlite3, file);
    session << "PRAGMA ignore_check_constraints = ON";
    EXPECT_EQ(reading_with(session, "trial_index = trial_index"), "");
    const std::pair<const char*, const char*> values[] = {
        {"is_A_selected = 7", "number 7"},
        {"trial_index = -1 - trial_index", "number -7"},
        {"response_time_s = -2.5", "number -2.5"},
        {"response_time_s = 9e999", "number inf"},
        {"first_shown = 'C'", "side 'C'"},
        {"kind = 'person'", "kind 'person'"},
        {"validity = 'lowly'", "level of validity 'lowly'"}};
    for (const auto& [value, expected] : values) {
        EXPECT_THAT(reading_with(session, value), HasSubstr(expected)) << value;
    }
}

class StoreMoment : public testing::TestWithParam<Moment> {};
INSTANTIATE_TEST_SUITE_P(All, StoreMoment, testing::Values(Moment::kCopied, Moment::kHeld));

TEST_P(StoreMoment, IsTheSameThroughoutAndKeepsAWriterWaitingOnlyWhereItIsHeld) {
    const tests::TemporaryFolder folder;
    const std::string url = "sqlite3://" + (folder / "responses.sqlite").string();
    tests::add_completed(*std::make_unique<Store>(url, Store::Access::kReadWrite), 0);
    Store store(url, Store::Access::kReadOnly);
    bool written = false;
    const auto read = [&] {
        const std::string display = store.sessions().front().display;
        Database other(url, false);
        other.execute("PRAGMA busy_timeout = 1");
        try {
            other.execute("UPDATE sessions SET display = display || '!'");
            written = true;
        } catch (const soci::soci_error&) {
            written = false;
        }
        EXPECT_EQ(store.sessions().front().display, display);
    };
    store.of_one_moment(read, GetParam());
    EXPECT_EQ(written, GetParam() == Moment::kCopied);
    EXPECT_EQ(store.sessions().front().display.ends_with('!'), written);
}

}  // namespace
}  // namespace obscura::analysis
