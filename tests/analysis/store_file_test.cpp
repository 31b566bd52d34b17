// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What may go wrong with the place where the store lies: every case has a clear error and leaves
// what was there as it was.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>

#include "analysis/store/database.h"
#include "analysis/store/schema.h"
#include "analysis/store/store.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;
using base::ExitCode;
using testing::HasSubstr;

class StoreFileTest : public testing::Test {
  protected:
    [[nodiscard]] std::string url() const { return "sqlite3://" + file.string(); }

    void expect_refused(Store::Access access, const std::string& text) const {
        try {
            const Store store(url(), access);
            ADD_FAILURE() << "opened; expected was: " << text;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadInput) << error.what();
            EXPECT_THAT(error.what(), HasSubstr(text));
            EXPECT_THAT(error.what(), HasSubstr(file.string()));
        }
    }

    void expect_refused_and_unchanged(const std::string& text) const {
        const std::string before = base::read_file(file);
        expect_refused(Store::Access::kReadWrite, text);
        expect_refused(Store::Access::kReadOnly, text);
        EXPECT_EQ(base::read_file(file), before);
        EXPECT_FALSE(fs::exists(file.string() + "-wal"));
        EXPECT_FALSE(fs::exists(file.string() + "-journal"));
    }

    tests::TemporaryFolder folder;
    fs::path file = folder / "responses.sqlite";
};

TEST_F(StoreFileTest, AFileThatIsNoDatabaseIsRefusedAndUntouched) {
    base::write_file_atomically(file, "condition,count_a,count_b\nI,18,18\n");
    expect_refused_and_unchanged("no SQLite database");
    base::write_file_atomically(file, "SQLite");
    expect_refused_and_unchanged("no SQLite database");
}

TEST_F(StoreFileTest, ADatabaseHeaderWithoutADatabaseIsRefusedAndUntouched) {
    base::write_file_atomically(file,
                                std::string("SQLite format 3\0", 16) + std::string(4096, 'x'));
    expect_refused_and_unchanged("no SQLite database");
}

TEST_F(StoreFileTest, ADatabaseOfAnotherProgramIsRefusedAndUntouched) {
    { Database(url(), false).execute("CREATE TABLE bookmarks (address TEXT)"); }
    expect_refused_and_unchanged("database of another program");
}

TEST_F(StoreFileTest, ANewerSchemaIsRefusedAndUntouched) {
    { const Store store(url(), Store::Access::kReadWrite); }
    { Database(url(), false).execute("UPDATE obscura_schema SET version = 99"); }
    expect_refused_and_unchanged("has schema version 99, this program knows versions up to");
}

TEST_F(StoreFileTest, ADirectoryIsRefused) {
    fs::create_directory(file);
    expect_refused(Store::Access::kReadWrite, "it is a directory");
    expect_refused(Store::Access::kReadOnly, "it is a directory");
    EXPECT_TRUE(fs::is_empty(file));
}

TEST_F(StoreFileTest, ADeviceIsRefused) {
    file = "/dev/null";
    expect_refused(Store::Access::kReadWrite, "no regular file");
}

TEST_F(StoreFileTest, ReadingOnlyMakesNoStore) {
    expect_refused(Store::Access::kReadOnly, "there is no such file");
    EXPECT_FALSE(fs::exists(file));
    base::write_file_atomically(file, "");
    expect_refused(Store::Access::kReadOnly, "it is empty");
    EXPECT_EQ(fs::file_size(file), 0U);
}

TEST_F(StoreFileTest, ReadingOnlyChangesNothing) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    const std::string before = base::read_file(file);
    { EXPECT_EQ(Store(url(), Store::Access::kReadOnly).trials().size(), 7U); }
    EXPECT_EQ(base::read_file(file), before);
}

TEST_F(StoreFileTest, OtherUrlsAreRefused) {
    for (const std::string bad : {"", "responses.sqlite", "sqlite3://", "mysql://host/db"}) {
        try {
            const Store store(bad, Store::Access::kReadWrite);
            ADD_FAILURE() << "opened " << bad;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadInput);
            EXPECT_THAT(error.what(), HasSubstr("allowed are sqlite3://FILE and postgresql://"));
        }
    }
}

TEST_F(StoreFileTest, AServerThatIsNotThereIsBadInputAndItsPasswordStaysSecret) {
    try {
        const Store store("postgresql://reader:secret@127.0.0.1:1/none", Store::Access::kReadOnly);
        ADD_FAILURE() << "opened";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadInput) << error.what();
        EXPECT_THAT(error.what(), testing::Not(HasSubstr("secret")));
        EXPECT_THAT(error.what(), HasSubstr("127.0.0.1"));
    }
}

/// Runs `work` in a child without the rights of root, which no read-only place can stop; gives
/// whether it returned true.
bool holds_for_an_ordinary_user(const std::function<bool()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t kNobody = 65534;
        if (::geteuid() == 0 && (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)) ::_exit(2);
        ::_exit(work() ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool is_refused(const std::string& url, const std::string& text) {
    try {
        const Store store(url, Store::Access::kReadWrite);
    } catch (const base::Error& error) {
        if (error.code() == ExitCode::kBadInput &&
            std::string(error.what()).find(text) != std::string::npos) {
            return true;
        }
        fmt::print(stderr, "{}\n", error.what());
    }
    return false;
}

TEST_F(StoreFileTest, AReadOnlyFolderOrFileIsRefusedForWritingAndUntouched) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    const std::string before = base::read_file(file);
    fs::permissions(file, fs::perms::owner_read | fs::perms::others_read);
    fs::permissions(folder.path(), fs::perms::all);
    EXPECT_TRUE(holds_for_an_ordinary_user([&] { return is_refused(url(), "Permission denied"); }));
    fs::permissions(file, fs::perms::all);
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec |
                                       fs::perms::others_read | fs::perms::others_exec);
    EXPECT_TRUE(holds_for_an_ordinary_user([&] { return is_refused(url(), "Permission denied"); }));
    EXPECT_TRUE(holds_for_an_ordinary_user([&] {
        return Store(url(), Store::Access::kReadOnly).trials().size() == 7;
    })) << "reading needs no right to write";
    fs::permissions(folder.path(), fs::perms::all);
    EXPECT_EQ(base::read_file(file), before);
}

TEST_F(StoreFileTest, EachPageThatIsDamagedIsFoundWhenTheStoreIsOpened) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    constexpr std::size_t kPage = 4096;
    const std::string whole = base::read_file(file);
    ASSERT_EQ(whole.size() % kPage, 0U);
    for (std::size_t page = 1; page * kPage < whole.size(); ++page) {
        for (const char filling : {'\0', '\x5a'}) {
            std::string bytes = whole;
            bytes.replace(page * kPage, kPage, std::string(kPage, filling));
            base::write_file_atomically(file, bytes);
            expect_refused_and_unchanged("is damaged");
        }
    }
    base::write_file_atomically(file, whole.substr(0, whole.size() - kPage));
    expect_refused_and_unchanged("is damaged");
}

[[noreturn]] void be_killed() {
    ::kill(::getpid(), SIGKILL);
    std::abort();
}

/// What a program leaves beside the store that is killed within `work`.
void in_a_program(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
}

TEST_F(StoreFileTest, TheLogOfAnEarlierVersionIsFoldedInWhenTheStoreIsOpenedForWriting) {
    { const Store store(url(), Store::Access::kReadWrite); }
    in_a_program([&] {
        Database earlier(url(), false);
        earlier.execute("PRAGMA journal_mode = WAL");
        Store store(url(), Store::Access::kReadOnly);  // which leaves the mode as it is
        Transaction transaction(earlier);
        earlier.execute(
            "INSERT INTO events (time_utc, name, detail) VALUES ('2026-05-01T12:00:00Z', 'an "
            "event', '')");
        transaction.commit();
        be_killed();
    });
    ASSERT_TRUE(fs::exists(file.string() + "-wal"));
    fs::copy_file(file, folder / "before.sqlite");
    const auto events_in = [&](const char* name) {
        return Store("sqlite3://" + (folder / name).string(), Store::Access::kReadOnly)
            .events()
            .size();
    };
    EXPECT_EQ(events_in("before.sqlite"), 0U) << "there is nothing to fold in";
    const Store store(url(), Store::Access::kReadWrite);
    EXPECT_FALSE(fs::exists(file.string() + "-wal"));
    EXPECT_FALSE(fs::exists(file.string() + "-shm"));
    fs::copy_file(file, folder / "after.sqlite");
    EXPECT_EQ(events_in("after.sqlite"), 1U);
}

TEST_F(StoreFileTest, AnAnswerCutOffInTheMiddleIsTakenBackWhenTheStoreIsOpened) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    for (const auto access : {Store::Access::kReadWrite, Store::Access::kReadOnly}) {
        in_a_program([&] {
            Database database(url(), false);
            database.execute("PRAGMA cache_size = 1");  // so that pages go to the file early
            const Transaction transaction(database);
            for (int i = 0; i < 200; ++i) {
                database.execute(
                    "INSERT INTO events (time_utc, name, detail) VALUES ('2026-05-01T12:00:00Z', "
                    "'half an answer', 'which no call acknowledged')");
            }
            be_killed();
        });
        ASSERT_TRUE(fs::exists(file.string() + "-journal"));
        Store store(url(), access);
        EXPECT_EQ(store.events().size(), 1U);
        EXPECT_EQ(store.trials().size(), 7U);
        EXPECT_FALSE(fs::exists(file.string() + "-journal"));
    }
}

TEST_F(StoreFileTest, AStoreThatIsMovedDeletedOrReplacedWhileItIsOpenIsNoticed) {
    Store store(url(), Store::Access::kReadWrite);
    store.begin_session(tests::a_participant(0), tests::a_session(0));
    const auto expect_noticed = [&](const std::string& text) {
        for (const auto& work :
             std::vector<std::function<void()>>{[&] { store.require_in_place(); },
                                                [&] { store.add_trial(tests::a_trial(0, 0)); }}) {
            try {
                work();
                ADD_FAILURE() << "not noticed; expected was: " << text;
            } catch (const base::Error& error) {
                EXPECT_EQ(error.code(), ExitCode::kFailed);
                EXPECT_THAT(error.what(), HasSubstr(text));
                EXPECT_THAT(error.what(), HasSubstr(file.string()));
            }
        }
    };
    fs::rename(file, folder / "elsewhere.sqlite");
    expect_noticed("was moved or deleted");
    fs::copy_file(folder / "elsewhere.sqlite", file);
    expect_noticed("was replaced by another file");
    fs::rename(folder / "elsewhere.sqlite", file);
    EXPECT_NO_THROW(store.require_in_place());
    store.add_trial(tests::a_trial(0, 0));
    EXPECT_EQ(Store(url(), Store::Access::kReadOnly).trials().size(), 1U);
    fs::remove(file);
    expect_noticed("was moved or deleted");
}

const int kNext = migrations().back().version + 1;

const std::vector<Migration>& one_more_step() {
    static const std::vector<Migration> steps = [] {
        std::vector<Migration> list = migrations();
        list.push_back({kNext, {"ALTER TABLE participants ADD COLUMN shoe_size {integer}"}});
        return list;
    }();
    return steps;
}

TEST_F(StoreFileTest, AnOlderSchemaIsBroughtUpToDateWithItsRows) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    Database database(url(), false);
    EXPECT_THROW(require_current(database, one_more_step()), base::Error);
    migrate(database, one_more_step());
    EXPECT_EQ(schema_version(database), kNext);
    int rows = 0;
    database.session() << "SELECT COUNT(*) FROM trials, participants WHERE shoe_size IS NULL",
        soci::into(rows);
    EXPECT_EQ(rows, 7);
    migrate(database, one_more_step());  // nothing to do
    EXPECT_EQ(schema_version(database), kNext);
    EXPECT_THROW(migrate(database, migrations()), base::Error);
}

TEST_F(StoreFileTest, TrialsOfAnOlderStoreDoNotKnowHowLongTheyWereHidden) {
    {
        auto older = migrations();
        std::erase_if(older, [](const Migration& step) { return step.version > 2; });
        Database database(url(), false);
        migrate(database, older);
        database.execute(
            "INSERT INTO participants (participant_id, kind, gender, consent, created_utc) VALUES "
            "('p0', 'participant', '', 1, '2026-05-01T12:00:00Z')");
        database.execute(
            "INSERT INTO sessions (session_id, participant_id, kind, study, study_sha256, "
            "order_kind, seed, slot, latin_square, latin_row, swapped, condition_count, state, "
            "started_utc, software, operating_system, gpu_renderer, display, refresh_hz) VALUES "
            "('s0', 'p0', 'participant', 'study', '', 'fixed', 1, 0, 0, 0, 0, 2, 'open', "
            "'2026-05-01T12:00:00Z', '', '', '', '', 0.0)");
        database.execute(
            "INSERT INTO trials (session_id, kind, trial_index, condition, hypothesis, scene, "
            "validity, condition_A, condition_B, first_shown, response_first, is_A_selected, "
            "response_time_s, first_onset_s, second_onset_s, question_onset_s, first_view_ms, "
            "second_view_ms, grey_ms_measured, dropped_frames, first_sha256, second_sha256, "
            "answered_utc) VALUES ('s0', 'participant', 0, 'C0', '', '', 'low', 'None', "
            "'Crytek8', 'A', 1, 1, 1.0, 1.0, 2.0, 3.0, 1.0, 1.0, 1.0, 0, '', '', "
            "'2026-05-01T12:00:00Z')");
    }
    Store store(url(), Store::Access::kReadWrite);
    EXPECT_EQ(store.trials().at(0).hidden_ms, std::nullopt);
    TrialRecord next = tests::a_trial(0, 1);
    next.hidden_ms = 0.0;
    store.add_trial(next);
    EXPECT_EQ(store.trials().at(1).hidden_ms, 0.0);
}

TEST_F(StoreFileTest, AMigrationThatFailsChangesNothing) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    auto steps = one_more_step();
    steps.push_back(
        {kNext + 1, {"DROP TABLE events", "ALTER TABLE nowhere ADD COLUMN nothing {integer}"}});
    Database database(url(), false);
    EXPECT_ANY_THROW(migrate(database, steps));
    EXPECT_EQ(schema_version(database), kNext - 1);
    Store store(url(), Store::Access::kReadOnly);
    EXPECT_EQ(store.events().size(), 1U);
    EXPECT_EQ(store.participants().front(), tests::a_participant(0));
}

TEST_F(StoreFileTest, ATransactionIsRolledBackUnlessCommitted) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    Database database(url(), false);
    const auto count_events = [&] {
        int count = 0;
        database.session() << "SELECT COUNT(*) FROM events", soci::into(count);
        return count;
    };
    {
        const Transaction transaction(database);
        database.execute("DELETE FROM events");
        EXPECT_EQ(count_events(), 0);
    }
    EXPECT_EQ(count_events(), 1);
    try {
        const Transaction transaction(database);
        database.execute("DELETE FROM events");
        throw std::runtime_error("in the middle");
    } catch (const std::runtime_error&) {
        EXPECT_EQ(count_events(), 1);
    }
    {
        Transaction transaction(database);
        database.execute("DELETE FROM events");
        transaction.commit();
    }
    EXPECT_EQ(count_events(), 0);
}

/// The constraints hold against other programs too, which know nothing of our checks.
TEST_F(StoreFileTest, TheSchemaItselfRefusesRowsThatCannotBe) {
    { tests::add_completed(*std::make_unique<Store>(url(), Store::Access::kReadWrite), 0); }
    Database database(url(), false);
    for (const char* statement : {
             "UPDATE trials SET is_A_selected = 1 WHERE trial_index = 0",
             "UPDATE trials SET is_A_selected = NULL",
             "UPDATE trials SET first_shown = 'C'",
             "UPDATE trials SET kind = 'guest'",
             "UPDATE trials SET session_id = 'nobody'",
             "UPDATE trials SET response_time_s = -1",
             "UPDATE trials SET response_time_s = 'soon'",
             "UPDATE trials SET trial_index = 0",
             "UPDATE trials SET condition = 'same'",
             "UPDATE trials SET expected = 'A'",
             "UPDATE trials SET repeats = condition",
             "UPDATE trials SET repeats = 'C1', kind = 'practice'",
             "UPDATE sessions SET exclusion = ''",
             "UPDATE sessions SET participant_id = 'nobody'",
             "UPDATE sessions SET state = 'open'",
             "UPDATE sessions SET swapped = 2",
             "UPDATE sessions SET ended_utc = 'now'",
             "UPDATE participants SET age_years = 0",
             "UPDATE participants SET kind = 'practice'",
             "UPDATE events SET session_id = 'nobody'",
             "DELETE FROM sessions",
             "DELETE FROM participants",
         }) {
        EXPECT_THROW(database.execute(statement), soci::soci_error) << statement;
    }
}

}  // namespace
}  // namespace obscura::analysis
