// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "tests/support/postgres.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <thread>

#include "analysis/store/address.h"
#include "analysis/store/store.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/app/commands/readme_commands.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;
using tests::PostgresServer;

TEST(PostgresAddress, ItsPasswordIsInNoMessageHoweverItIsGiven) {
    for (const char* url :
         {"postgresql://reader:secret@lab:5433/answers", "postgres://reader:secret@lab/answers",
          "postgresql://reader:secret@lab1:1,lab2:2/answers", "postgresql://reader:@lab/secret=no",
          "postgresql://lab/answers?user=reader&password=secret&sslmode=require",
          "postgresql://lab/answers?sslpassword=secret&user=reader",
          "host=lab user=reader password=secret dbname=answers",
          "host=lab password = 'se\\'secret cret' user=reader", "password=secret",
          "postgresql://reader:secret@lab:port/answers",
          "postgresql://reader:secret@lab/answers?nonsense=1", "host=lab password='secret",
          "postgresql://re%zzader:secret@lab/answers"}) {
        EXPECT_THAT(without_password(url), Not(HasSubstr("secret@"))) << url;
        if (std::string(url).find("secret=no") == std::string::npos) {
            EXPECT_THAT(without_password(url), Not(HasSubstr("secret"))) << url;
        }
        try {
            const StoreAddress address = store_address(url);
            EXPECT_EQ(address.file, "");
            if (std::string(url).find("secret=no") == std::string::npos) {
                EXPECT_THAT(address.shown, Not(HasSubstr("secret"))) << url;
            }
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            EXPECT_THAT(error.what(), Not(HasSubstr("secret"))) << url;
        }
    }
}

TEST(PostgresAddress, WhatIsShownSaysWhereItIs) {
    EXPECT_EQ(store_address("postgresql://reader:x@lab:5433/answers").shown,
              "postgresql://reader@lab:5433/answers");
    EXPECT_EQ(store_address("host=lab dbname=answers").shown, "postgresql://lab/answers");
    EXPECT_EQ(store_address("postgresql:///answers?host=lab&port=7").shown,
              "postgresql://lab:7/answers");
    EXPECT_EQ(store_address("sqlite3://a b=c.sqlite").file, "a b=c.sqlite");
    EXPECT_EQ(without_password("sqlite3:///x:y@z/a.sqlite"), "sqlite3:///x:y@z/a.sqlite");
}

TEST(PostgresStore, OpensByEveryFormOfAddressThatLibpqTakes) {
    PostgresServer& server = PostgresServer::shared();
    const std::string url = server.new_database();
    const std::string database = url.substr(url.rfind('/') + 1);
    const int port = server.port();
    const std::string postgres = "postgres" + url.substr(std::string("postgresql").size());
    const tests::TemporaryFolder folder;
    base::write_file_atomically(
        folder / "services",
        fmt::format("[laboratory]\nhost=127.0.0.1\nport={}\nuser=operator\ndbname={}\n", port,
                    database));
    ::setenv("PGSERVICEFILE", (folder / "services").c_str(), 1);
    { tests::add_completed(*std::make_unique<Store>(url, Store::Access::kReadWrite), 0); }
    for (const std::string& form :
         {url, postgres,
          fmt::format("postgresql://operator:unused@127.0.0.1:{}/{}", port, database),
          fmt::format("postgresql:///{}?host=127.0.0.1&port={}&user=operator", database, port),
          fmt::format("postgresql://operator@127.0.0.1:1,127.0.0.1:{}/{}", port, database),
          fmt::format("postgresql://operator@localhost:{}/{}?hostaddr=127.0.0.1", port, database),
          fmt::format("host=127.0.0.1 port={} user=operator dbname={}", port, database),
          fmt::format("host = 127.0.0.1 port='{}' user=operator password='a \\'b' dbname={}", port,
                      database),
          std::string("postgresql://?service=laboratory"), std::string("service=laboratory")}) {
        EXPECT_EQ(Store(form, Store::Access::kReadOnly).sessions().size(), 1U) << form;
    }
    ::unsetenv("PGSERVICEFILE");
}

TEST(PostgresStore, ADatabaseThatIsNotThereIsBadInput) {
    const std::string url = PostgresServer::shared().new_database() + "x";
    try {
        const Store store(url, Store::Access::kReadWrite);
        ADD_FAILURE() << "opened";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        EXPECT_THAT(error.what(), HasSubstr("does not exist"));
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    }
}

TEST(PostgresStore, ARoleWithNoMoreRightsThanItNeedsRunsAndOneThatReadsCannotWrite) {
    PostgresServer& server = PostgresServer::shared();
    const std::string url = server.new_database();
    { tests::add_completed(*std::make_unique<Store>(url, Store::Access::kReadWrite), 0); }
    const std::string database = url.substr(url.rfind('/') + 1);
    const auto as = [&](const std::string& role) {
        return fmt::format("postgresql://{}@127.0.0.1:{}/{}", role, server.port(), database);
    };
    const std::vector<std::string> rights = app::readme_blocks("README.md", "sql");
    ASSERT_EQ(rights.size(), 1U);
    server.execute(rights[0], database);
    server.execute("CREATE ROLE reader LOGIN", database);
    server.execute("GRANT SELECT ON ALL TABLES IN SCHEMA public TO reader", database);
    { tests::add_completed(*std::make_unique<Store>(as("kiosk"), Store::Access::kReadWrite), 1); }
    Store reading(as("reader"), Store::Access::kReadOnly);
    EXPECT_EQ(reading.trials().size(), 14U);
    EXPECT_THROW(reading.add_event({"", tests::kUtc, "event", ""}), base::Error);
}

TEST(PostgresStore, HoweverManyKiosksBeginAtOnceEachRowOfTheOrderIsGivenOnce) {
    const std::string url = PostgresServer::shared().new_database();
    { const Store made(url, Store::Access::kReadWrite); }
    constexpr int kKiosks = 6;
    constexpr int kSessions = 10;
    std::vector<std::thread> kiosks;
    std::atomic<int> failures = 0;
    for (int kiosk = 0; kiosk < kKiosks; ++kiosk) {
        kiosks.emplace_back([&, kiosk] {
            try {
                Store store(url, Store::Access::kReadWrite);
                for (int i = 0; i < kSessions; ++i) {
                    const int number = kiosk * kSessions + i;
                    auto session = tests::a_session(number);
                    session.slot = 0;
                    store.begin_session(
                        tests::a_participant(number), session, {},
                        [](SessionRecord& moved, const std::vector<std::uint64_t>& taken) {
                            std::uint64_t next = 0;
                            for (const auto slot : taken) next += slot == next ? 1U : 0U;
                            moved.slot = next;
                        });
                    store.add_trial(tests::a_trial(number, 0));
                }
            } catch (const std::exception& error) {
                ADD_FAILURE() << error.what();
                ++failures;
            }
        });
    }
    for (std::thread& kiosk : kiosks) kiosk.join();
    ASSERT_EQ(failures, 0);
    Store store(url, Store::Access::kReadOnly);
    EXPECT_EQ(store.trials().size(), std::size_t{kKiosks * kSessions});
    const auto slots = store.taken_slots("jakobsen2010", 20100501, Kind::kParticipant);
    ASSERT_EQ(slots.size(), std::size_t{kKiosks * kSessions});
    for (std::size_t i = 0; i < slots.size(); ++i) {
        EXPECT_EQ(slots[i], i) << "none is left out and none is given twice";
    }
}

TEST(PostgresStore, AChangeTakesItsTurnAndGoesOnWithoutWhereAnotherKeepsItTooLong) {
    PostgresServer& server = PostgresServer::shared();
    const std::string url = server.new_database();
    const std::string database = url.substr(url.rfind('/') + 1);
    const std::string held = "EXISTS (SELECT FROM pg_locks WHERE locktype = 'advisory')";
    const auto require = [&](const std::string& condition) {
        server.execute(
            "DO $$ BEGIN IF NOT " + condition + " THEN RAISE EXCEPTION 'not so'; END IF; END $$",
            database);
    };
    Store store(url, Store::Access::kReadWrite);
    tests::add_completed(store, 0);
    EXPECT_NO_THROW(require("NOT " + held));
    std::thread frozen([&] {
        // The number is the store's own; another would keep nobody waiting.
        EXPECT_ANY_THROW(server.execute(
            fmt::format("SELECT pg_advisory_lock({}), pg_sleep(600)", 0x6f627363), database));
    });
    while (true) {
        try {
            require(held);
            break;
        } catch (const std::exception&) {
            std::this_thread::yield();
        }
    }
    store.begin_session(tests::a_participant(1), tests::a_session(1));
    EXPECT_NO_THROW(require(held)) << "nobody kept it";
    server.execute("SELECT pg_terminate_backend(pid) FROM pg_locks WHERE locktype = 'advisory'",
                   database);
    frozen.join();
    EXPECT_EQ(store.sessions().size(), 2U);
}

TEST(PostgresStore, AServerThatWasAwayIsTakenUpAgainAndLosesNothingThatItAcknowledged) {
    PostgresServer& server = PostgresServer::shared();
    Store store(server.new_database(), Store::Access::kReadWrite);
    store.begin_session(tests::a_participant(0), tests::a_session(0));
    store.add_trial(tests::a_trial(0, 0));
    server.restart();
    int given = 1;
    for (int attempt = 0; attempt < 3 && given < 3; ++attempt) {
        try {
            store.add_trial(tests::a_trial(0, given));
            ++given;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kFailed) << error.what();
        }
    }
    EXPECT_EQ(given, 3);
    EXPECT_EQ(store.trials_of("s0").size(), 3U);
}

}  // namespace
}  // namespace obscura::analysis
