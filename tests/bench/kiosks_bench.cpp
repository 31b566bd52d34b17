// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Kiosks that share one store, each a thread with simulated participants who never wait. Kiosks are
// killed at random; of a PostgreSQL connections are cut as well, and the server is restarted in the
// middle. Says how many answers are there once, twice or not at all, how balanced the order is, and
// how long a commit takes.
//   kiosks_bench [SESSIONS] [KIOSKS] [postgresql|sqlite] [calm]
// `calm` kills and cuts nothing. `obscura run` keeps an SQLite store to one kiosk: more of them
// here show what the store alone would bear.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "app/kiosk/clock.h"
#include "app/kiosk/machine.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "renderer/base/random.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/support/postgres.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Kind;
using analysis::Store;
using analysis::TrialRecord;

void pause_ms(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

struct Bench {
    stimuli::Study study = small_study(7, 0);
    stimuli::Manifest manifest = small_manifest(study);
    ChoiceModel choices = choices_from(study, {});
    std::string url;
    bool on_server = true;
    bool calm = false;
    std::filesystem::path folder;
    std::atomic<int> sessions_left{0};
    std::atomic<int> kills{0};
    std::mutex mutex;
    std::vector<double> commit_ms;
    std::map<std::string, std::string> saved;  ///< answers that were acknowledged, by their place
};

std::string place_of(const TrialRecord& trial) {
    return fmt::format("{} {}", trial.session_id, trial.trial_index);
}
std::string answer_of(const TrialRecord& trial) {
    return fmt::format("{} {} {}", trial.condition, trial.is_A_selected, trial.answered_utc);
}

/// One kiosk; a kill throws its connection and spool away in the middle and begins anew.
class KioskThread {
  public:
    KioskThread(Bench& bench, int number)
        : bench_(bench),
          random_(static_cast<std::uint64_t>(number) + 1),
          url_(bench.url),
          folder_(bench.folder / fmt::format("kiosk-{}", number)) {
        std::filesystem::create_directories(folder_);
    }

    void run() {
        start();
        while (bench_.sessions_left.fetch_sub(1) > 0) run_session();
    }

  private:
    void start() {
        store_.reset();
        again([&] { store_ = std::make_unique<Store>(url_, Store::Access::kReadWrite); });
        if (!bench_.on_server) return;
        spool_ = std::make_unique<Spool>(folder_, url_);
        again([&] {
            if (spool_->waits()) spool_->deliver(*store_);
        });
    }

    /// As an operator does who tries again.
    template <typename Work>
    void again(const Work& work) {
        while (true) {
            try {
                work();
                return;
            } catch (const std::exception&) {
                pause_ms(20);
            }
        }
    }

    void run_session() {
        const std::string id = unique_id("s");
        while (!play(id)) {
            ++bench_.kills;
            start();
        }
    }

    /// False: it was killed.
    bool play(const std::string& id) {
        std::vector<analysis::SessionRecord> sessions;
        again([&] { sessions = store_->sessions(); });
        const auto own = std::find_if(sessions.begin(), sessions.end(),
                                      [&](const auto& one) { return one.session_id == id; });
        if (own == sessions.end()) {
            SessionPlan plan;
            plan.participant_id = "p" + id;
            plan.session_id = id;
            plan.images = images_of(bench_.study, bench_.manifest);
            plan.machine = simulated_machine();
            again([&] {
                plan.order = bench_.study.session_order(stimuli::next_slot(
                    store_->taken_slots(bench_.study.name, bench_.study.seed, plan.kind)));
            });
            Procedure procedure(bench_.study, plan);
            return observe(procedure, {});
        }
        if (own->state != analysis::SessionState::kOpen) return true;
        return resume(*own);
    }

    bool resume(const analysis::SessionRecord& session) {
        std::vector<TrialRecord> trials;
        std::vector<analysis::EventRecord> events;
        again([&] {
            trials = store_->trials_of(session.session_id);
            events = store_->events_of(session.session_id);
            for (const auto& participant : store_->participants()) {
                if (participant.participant_id != session.participant_id) continue;
                if (spool_) spool_->follow(BeginSession{participant, session, {}});
            }
        });
        for (const TrialRecord& trial : trials) {
            if (spool_) spool_->follow(trial);
        }
        Procedure procedure(bench_.study,
                            plan_to_resume(bench_.study, bench_.manifest, session, trials, events));
        return observe(procedure, procedure.resume(trials, !trials.empty(), 100.0, moment_now()));
    }

    bool observe(Procedure& procedure, std::vector<Row> rows) {
        Journal inner = spool_ ? journal_to(*store_, bench_.study, procedure, *spool_)
                               : journal_to(*store_, bench_.study, procedure);
        bool killed = false;
        Journal journal([&](const Row& row) {
            const bool before = !bench_.calm && random_.below(400) == 0;
            const bool after = !bench_.calm && random_.below(400) == 0;
            killed = before || after;
            if (before) throw std::runtime_error("killed");
            inner.add({row});
            const double from_s = monotonic_s();
            while (inner.flush()) pause_ms(20);
            note(row, (monotonic_s() - from_s) * 1000.0);
            if (after) throw std::runtime_error("killed");
        });
        journal.add(std::move(rows));
        VirtualClock clock;
        clock.pass(monotonic_s());
        try {
            simulate_observer(procedure, bench_.choices, random_, clock, journal);
        } catch (const std::exception&) {
            if (!killed) throw;
        }
        return !killed;
    }

    void note(const Row& row, double took_ms) {
        const std::lock_guard lock(bench_.mutex);
        bench_.commit_ms.push_back(took_ms);
        if (const auto* trial = std::get_if<TrialRecord>(&row)) {
            bench_.saved[place_of(*trial)] = answer_of(*trial);
        }
    }

    Bench& bench_;
    base::Random random_;
    std::string url_;
    std::filesystem::path folder_;
    std::unique_ptr<Store> store_;
    std::unique_ptr<Spool> spool_;
};

/// Cuts a connection now and then, and restarts the server once half of the sessions have begun.
void disturb(tests::PostgresServer& server, const std::string& database, const Bench& bench,
             int sessions, std::atomic<bool>& done, int& cuts, int& restarts) {
    base::Random random(99);
    while (!done) {
        pause_ms(100 + static_cast<int>(random.below(400)));
        if (restarts == 0 && bench.sessions_left < sessions / 2) {
            server.restart();
            ++restarts;
            continue;
        }
        server.execute(
            fmt::format("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE "
                        "datname = '{}' AND pid <> pg_backend_pid() ORDER BY random() "
                        "LIMIT 1",
                        database));
        ++cuts;
    }
}

void report(Bench& bench, double took_s) {
    Store store(bench.url, Store::Access::kReadWrite);
    std::map<std::string, std::string> found;
    std::size_t twice = 0;
    for (const TrialRecord& trial : store.trials()) {
        if (!found.emplace(place_of(trial), answer_of(trial)).second) ++twice;
    }
    std::size_t lost = 0;
    for (const auto& [place, answer] : bench.saved) {
        const auto is = found.find(place);
        if (is == found.end() || is->second != answer) ++lost;
    }
    std::size_t completed = 0;
    std::set<std::uint64_t> slots;
    for (const auto& session : store.sessions()) {
        if (session.state == analysis::SessionState::kCompleted) ++completed;
        slots.insert(session.slot);
    }
    auto& times = bench.commit_ms;
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) {
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    fmt::print(
        "{} sessions completed of {}, {} slots of which the last is {}\n"
        "{} answers acknowledged, {} lost or changed, {} in the store, {} of them twice\n"
        "{:.1f} s, {:.0f} answers a second; a commit takes {:.2f} ms at the median, {:.2f} ms at "
        "the 99th percentile, {:.0f} ms at most\n",
        completed, store.sessions().size(), slots.size(), *slots.rbegin(), bench.saved.size(), lost,
        found.size(), twice, took_s, static_cast<double>(found.size()) / took_s, at(0.5), at(0.99),
        times.back());
}

/// A server whose database the kiosks share; none: an SQLite store.
tests::PostgresServer* open_store(Bench& bench) {
    if (!bench.on_server) {
        bench.url = "sqlite3://" + (bench.folder / "responses.sqlite").string();
        return nullptr;
    }
    tests::PostgresServer& server = tests::PostgresServer::shared();
    bench.url = server.new_database();
    // The tests' server does not wait for its disk, that of a laboratory does.
    server.execute("ALTER SYSTEM SET fsync = on");
    server.execute("SELECT pg_reload_conf()");
    return &server;
}

int run(int sessions, int kiosks, bool on_server, bool calm) {
    Bench bench;
    bench.on_server = on_server;
    bench.calm = calm;
    bench.folder = std::filesystem::temp_directory_path() / unique_id("obscura-kiosks-bench");
    std::filesystem::create_directories(bench.folder);
    tests::PostgresServer* const server = open_store(bench);
    bench.sessions_left = sessions;
    { const Store made(bench.url, Store::Access::kReadWrite); }
    std::atomic<bool> done{false};
    int cuts = 0;
    int restarts = 0;
    const double from_s = monotonic_s();
    double took_s = 0.0;
    std::thread all([&] {
        std::vector<std::thread> threads;
        for (int number = 0; number < kiosks; ++number) {
            threads.emplace_back([&bench, number] { KioskThread(bench, number).run(); });
        }
        for (std::thread& thread : threads) thread.join();
        took_s = monotonic_s() - from_s;
        done = true;
    });
    // Here, because the server ends with the thread that started it.
    if (server != nullptr && !calm) {
        disturb(*server, bench.url.substr(bench.url.rfind('/') + 1), bench, sessions, done, cuts,
                restarts);
    }
    all.join();
    fmt::print("{} kiosks on {}, {} kills, {} connections cut, {} restarts of the server\n", kiosks,
               on_server ? "PostgreSQL" : "SQLite", bench.kills.load(), cuts, restarts);
    report(bench, took_s);
    std::filesystem::remove_all(bench.folder);
    return 0;
}

}  // namespace
}  // namespace obscura::app::kiosk

int main(int count, char** arguments) {
    const int sessions = count > 1 ? std::atoi(arguments[1]) : 1000;
    const int kiosks = count > 2 ? std::atoi(arguments[2]) : 10;
    const std::string store = count > 3 ? arguments[3] : "postgresql";
    const std::string manner = count > 4 ? arguments[4] : "";
    if ((store != "postgresql" && store != "sqlite") || (!manner.empty() && manner != "calm")) {
        fmt::print(stderr, "kiosks_bench [SESSIONS] [KIOSKS] [postgresql|sqlite] [calm]\n");
        return 2;
    }
    return obscura::app::kiosk::run(std::max(1, sessions), std::max(1, kiosks),
                                    store == "postgresql", manner == "calm");
}
