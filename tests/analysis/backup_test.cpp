// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <set>

#include "analysis/store/store.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

mode_t mode_of(const fs::path& file) {
    struct stat status {};
    EXPECT_EQ(::stat(file.c_str(), &status), 0) << file;
    return status.st_mode & 0777U;
}

class Backups : public testing::Test {
  protected:
    tests::TemporaryFolder folder_;
    fs::path file_ = folder_ / "with blank" / "responses.sqlite";
    fs::path backups_ = folder_ / "back ups";
    Store store_{"sqlite3://" + file_.string(), Store::Access::kReadWrite};
};

TEST_F(Backups, ACopyHasEveryAnswerOfItsMomentAndIsReadByNobodyElse) {
    tests::add_completed(store_, 0);
    const auto copy = store_.back_up(backups_, "2026-11-26T21:05:33.120Z", 3);
    ASSERT_TRUE(copy.has_value());
    EXPECT_EQ(copy->filename(), "responses-20261126T210533Z.sqlite");
    tests::add_completed(store_, 1);
    Store read("sqlite3://" + copy->string(), Store::Access::kReadOnly);
    EXPECT_EQ(read.trials().size(), 7U);
    EXPECT_EQ(read.sessions().front().state, SessionState::kCompleted);
    EXPECT_EQ(mode_of(*copy), 0600U);
    EXPECT_EQ(mode_of(file_), 0600U) << "nor is the store itself";
}

TEST_F(Backups, OnlyTheLatestAreKeptAndNothingElseIsTouched) {
    fs::create_directories(backups_);
    base::write_file_atomically(backups_ / "responses-notes.txt", "mine");
    base::write_file_atomically(backups_ / "other-20200101T000000Z.sqlite", "another store's");
    for (int second = 0; second < 6; ++second) {
        (void)store_.back_up(backups_, fmt::format("2026-11-26T21:05:0{}Z", second), 3);
    }
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(backups_)) {
        names.insert(entry.path().filename().string());
    }
    EXPECT_THAT(names, testing::ElementsAre(
                           "other-20200101T000000Z.sqlite", "responses-20261126T210503Z.sqlite",
                           "responses-20261126T210504Z.sqlite", "responses-20261126T210505Z.sqlite",
                           "responses-notes.txt"));
}

TEST_F(Backups, OneThatCannotBeMadeLeavesTheOthersAndTheStoreAsTheyAre) {
    (void)store_.back_up(backups_, "2026-11-26T21:05:00Z", 1);
    const fs::path blocked = folder_ / "file";
    base::write_file_atomically(blocked, "no folder");
    EXPECT_THROW((void)store_.back_up(blocked, "2026-11-26T21:06:00Z", 1), std::exception);
    EXPECT_TRUE(fs::exists(backups_ / "responses-20261126T210500Z.sqlite"));
    tests::add_completed(store_, 0);
    EXPECT_EQ(store_.trials().size(), 7U);
}

TEST_F(Backups, TheLatestTimeIsThatOfAnyRow) {
    EXPECT_EQ(store_.latest_utc(), "");
    auto session = tests::a_session(0);
    session.started_utc = "2026-01-01T00:00:00Z";
    store_.begin_session(tests::a_participant(0), session);
    EXPECT_EQ(store_.latest_utc(), "2026-01-01T00:00:00Z");
    store_.add_event({"", "2026-03-01T00:00:00Z", "event", ""});
    EXPECT_EQ(store_.latest_utc(), "2026-03-01T00:00:00Z");
}

}  // namespace
}  // namespace obscura::analysis
