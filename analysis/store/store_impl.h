// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "analysis/store/database.h"
#include "analysis/store/read_ahead.h"
#include "analysis/store/rows.h"
#include "analysis/store/store.h"

namespace obscura::analysis {

/// What a store's sources share; of no use beyond them.
struct Store::Impl {
    Impl(const std::string& url, Access access) : database(url, access == Access::kReadOnly) {}
    Database database;

    /// Of a change that meets others: with ten kiosks the third is rare.
    static constexpr int kMostAttempts = 50;

    /// `work` in one transaction, its errors in the house's words.
    template <typename Work>
    void change(std::string_view doing, Work&& work) {
        database.guarded(doing, [&] {
            for (int attempt = 1; !changed(work, attempt == kMostAttempts); ++attempt) {
                // Those that met do not meet again at once.
                static thread_local std::minstd_rand random{std::random_device{}()};
                std::uniform_int_distribution<int> wait_ms(1, 5 * attempt);
                std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms(random)));
            }
        });
    }

    /// False: it met another one and is to be tried again.
    template <typename Work>
    bool changed(Work& work, bool last) {
        database.require_in_place();
        const Turn turn(database);
        try {
            Transaction transaction(database);
            work();
            transaction.commit();
            return true;
        } catch (const soci::soci_error& error) {
            if (last || !Database::asks_to_try_again(error)) throw;
            return false;
        }
    }

    template <typename Record>
    void each(const RecordTable<Record>& table, const std::string& rest,
              const std::function<void(const Record&)>& take) {
        database.read([&] {
            Rows<Record> rows(database.session(), table, rest);
            for (Record record; rows.next(record);) take(record);
        });
    }

    /// The same with a thread that reads on meanwhile: `take` must leave the store alone.
    template <typename Record>
    void each_ahead(const RecordTable<Record>& table, const std::string& rest,
                    const std::function<void(const Record&)>& take) {
        database.read([&] {
            Rows<Record> rows(database.session(), table, rest);
            read_ahead<Record>([&](Record& record) { return rows.next(record); }, take);
        });
    }

    template <typename Record>
    std::vector<Record> read(const RecordTable<Record>& table, const std::string& rest,
                             const std::vector<std::string>& values = {}) {
        return database.read([&] { return select(database.session(), table, rest, values); });
    }
};

[[nodiscard]] std::vector<std::uint64_t> slots_taken(Database& database, const std::string& study,
                                                     std::uint64_t seed, Kind kind);

}  // namespace obscura::analysis
