// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Whole sessions with the power cut at every write: everything that SQLite hands to the disk is
// recorded, and each prefix of that replayed, as it may be found afterwards.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <map>
#include <set>

#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "renderer/base/random.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

namespace fs = std::filesystem;
using analysis::SessionState;
using analysis::Store;
using analysis::TrialRecord;

/// One thing that was handed to the disk, or that the kiosk took for saved.
struct Step {
    enum class Kind { kWrite, kTruncate, kSync, kDelete, kSaved };
    Kind kind = Kind::kWrite;
    std::string file;
    std::size_t at = 0;  ///< where it is written, or the size that is left
    std::string bytes;
    int trials = 0;  ///< saved by then
};

/// SQLite's own way to the disk with a record of it. Nothing waits for the disk: what would be on
/// it is what the record says.
class RecordedDisk {
  public:
    RecordedDisk() : real_(sqlite3_vfs_find(nullptr)), vfs_(*real_) {
        current_ = this;
        vfs_.zName = "recorded";
        vfs_.szOsFile = static_cast<int>(sizeof(File)) + real_->szOsFile;
        vfs_.xOpen = open;
        vfs_.xDelete = remove;
        sqlite3_vfs_register(&vfs_, 1);
    }
    ~RecordedDisk() {
        sqlite3_vfs_unregister(&vfs_);
        sqlite3_vfs_register(real_, 1);
        current_ = nullptr;
    }
    RecordedDisk(const RecordedDisk&) = delete;
    RecordedDisk& operator=(const RecordedDisk&) = delete;

    void record(bool on) { records_ = on; }
    void saved(int trials) { note({Step::Kind::kSaved, "", 0, "", trials}); }
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }

  private:
    struct File {
        sqlite3_file base;
        const char* name;
        [[nodiscard]] sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
    };
    static File* of(sqlite3_file* file) { return reinterpret_cast<File*>(file); }
    static sqlite3_file* real(sqlite3_file* file) { return of(file)->real(); }

    static void note(Step step) {
        if (!current_->records_) return;
        step.file = fs::path(step.file).filename();
        current_->steps_.push_back(std::move(step));
    }
    static std::string name_of(sqlite3_file* file) {
        return of(file)->name != nullptr ? of(file)->name : "";
    }

    static int open(sqlite3_vfs* /*vfs*/, const char* name, sqlite3_file* file, int flags,
                    int* out_flags) {
        of(file)->name = name;
        sqlite3_vfs* vfs = current_->real_;
        const int result = vfs->xOpen(vfs, name, real(file), flags, out_flags);
        file->pMethods = real(file)->pMethods != nullptr ? &methods() : nullptr;
        return result;
    }
    static int remove(sqlite3_vfs* /*vfs*/, const char* name, int /*sync*/) {
        note({Step::Kind::kDelete, name, 0, "", 0});
        return current_->real_->xDelete(current_->real_, name, 0);
    }
    static const sqlite3_io_methods& methods() {
        static const sqlite3_io_methods kMethods = [] {
            sqlite3_io_methods made{};
            made.iVersion = 1;
            made.xClose = [](sqlite3_file* f) { return real(f)->pMethods->xClose(real(f)); };
            made.xRead = [](sqlite3_file* f, void* to, int size, sqlite3_int64 at) {
                return real(f)->pMethods->xRead(real(f), to, size, at);
            };
            made.xWrite = [](sqlite3_file* f, const void* from, int size, sqlite3_int64 at) {
                note({Step::Kind::kWrite, name_of(f), static_cast<std::size_t>(at),
                      std::string(static_cast<const char*>(from), static_cast<std::size_t>(size)),
                      0});
                return real(f)->pMethods->xWrite(real(f), from, size, at);
            };
            made.xTruncate = [](sqlite3_file* f, sqlite3_int64 size) {
                note({Step::Kind::kTruncate, name_of(f), static_cast<std::size_t>(size), "", 0});
                return real(f)->pMethods->xTruncate(real(f), size);
            };
            made.xSync = [](sqlite3_file* f, int /*flags*/) {
                note({Step::Kind::kSync, name_of(f), 0, "", 0});
                return SQLITE_OK;
            };
            made.xFileSize = [](sqlite3_file* f, sqlite3_int64* size) {
                return real(f)->pMethods->xFileSize(real(f), size);
            };
            made.xLock = [](sqlite3_file* f, int lock) {
                return real(f)->pMethods->xLock(real(f), lock);
            };
            made.xUnlock = [](sqlite3_file* f, int lock) {
                return real(f)->pMethods->xUnlock(real(f), lock);
            };
            made.xCheckReservedLock = [](sqlite3_file* f, int* out) {
                return real(f)->pMethods->xCheckReservedLock(real(f), out);
            };
            made.xFileControl = [](sqlite3_file* f, int op, void* arg) {
                return real(f)->pMethods->xFileControl(real(f), op, arg);
            };
            made.xSectorSize = [](sqlite3_file* f) {
                return real(f)->pMethods->xSectorSize(real(f));
            };
            made.xDeviceCharacteristics = [](sqlite3_file* /*f*/) { return 0; };
            return made;
        }();
        return kMethods;
    }

    static RecordedDisk* current_;
    sqlite3_vfs* real_;
    sqlite3_vfs vfs_;
    bool records_ = false;
    std::vector<Step> steps_;
};
RecordedDisk* RecordedDisk::current_ = nullptr;

/// What of the writes that no sync followed is there when the power is back.
enum class Unsynced { kAll, kNone, kSome };

/// The files after the first `count` steps.
class Disk {
  public:
    Disk(std::map<std::string, std::string> files, Unsynced unsynced, std::uint64_t seed)
        : synced_(std::move(files)), unsynced_(unsynced), random_(seed) {}

    void take(const Step& step) {
        if (step.kind == Step::Kind::kSync) {
            for (const Step& waiting : waiting_[step.file]) apply(waiting);
            waiting_[step.file].clear();
        } else if (step.kind == Step::Kind::kDelete) {
            // Synchronous EXTRA waits for the folder too.
            waiting_.erase(step.file);
            synced_.erase(step.file);
        } else if (step.kind != Step::Kind::kSaved) {
            waiting_[step.file].push_back(step);
        }
    }

    /// Into an empty folder.
    void write_to(const fs::path& folder) {
        for (const auto& [file, steps] : waiting_) {
            for (const Step& step : steps) {
                const bool kept = unsynced_ == Unsynced::kAll ||
                                  (unsynced_ == Unsynced::kSome && random_.below(2) == 0);
                if (kept) apply(step);
            }
        }
        for (const auto& [file, bytes] : synced_) {
            std::ofstream(folder / file, std::ios::binary) << bytes;
        }
    }

  private:
    void apply(const Step& step) {
        std::string& file = synced_[step.file];
        const bool writes = step.kind == Step::Kind::kWrite;
        if (!writes || file.size() < step.at + step.bytes.size()) {
            file.resize(step.at + step.bytes.size());
        }
        if (writes) file.replace(step.at, step.bytes.size(), step.bytes);
    }

    std::map<std::string, std::string> synced_;
    std::map<std::string, std::vector<Step>> waiting_;
    Unsynced unsynced_;
    base::Random random_;
};

class PowerCut : public testing::Test {
  protected:
    static std::string url_in(const fs::path& folder) {
        return "sqlite3://" + (folder / "a.sqlite").string();
    }
    static std::string bytes_of(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    /// A whole session of a simulated observer, recorded from its first row to its last.
    void play() {
        Store store(url_in(folder_.path()), Store::Access::kReadWrite);
        before_["a.sqlite"] = bytes_of(folder_ / "a.sqlite");
        disk_.record(true);
        int trials = 0;
        SessionPlan plan = small_plan(study_);
        plan.order = study_.session_order(0);
        Procedure procedure(study_, plan);
        Journal journal([&](const Row& row) {
            commit(store, row);
            if (std::holds_alternative<TrialRecord>(row)) ++trials;
            disk_.saved(trials);
        });
        base::Random random(5);
        VirtualClock clock;
        simulate_observer(procedure, choices_from(study_, {}), random, clock, journal);
        disk_.record(false);
        whole_ = store.trials();
    }

    /// What a cut after that many steps leaves.
    void expect_sound_after(std::size_t steps, Unsynced unsynced) {
        Disk disk(before_, unsynced, steps);
        int saved = 0;
        std::size_t rows = 0;
        for (std::size_t i = 0; i < steps; ++i) {
            disk.take(disk_.steps()[i]);
            if (disk_.steps()[i].kind != Step::Kind::kSaved) continue;
            saved = disk_.steps()[i].trials;
            ++rows;
        }
        const fs::path place = folder_ / fmt::format("cut-{}", cuts_++);
        fs::create_directory(place);
        disk.write_to(place);
        {
            Store store(url_in(place), Store::Access::kReadWrite);
            const auto trials = store.trials();
            EXPECT_GE(trials.size(), static_cast<std::size_t>(saved)) << steps;
            EXPECT_LE(trials.size(), static_cast<std::size_t>(saved) + 1) << steps;
            for (std::size_t i = 0; i < trials.size(); ++i) EXPECT_EQ(trials[i], whole_.at(i));
            found_.insert(trials.size());
            const auto sessions = store.sessions();
            EXPECT_GE(sessions.size(), rows > 0 ? 1U : 0U) << "the session was said to have begun";
            if (!sessions.empty() && sessions[0].state == SessionState::kOpen) {
                Procedure rest(study_, plan_to_resume(study_, small_manifest(study_), sessions[0],
                                                      trials, store.events()));
                Journal journal = journal_to(store);
                journal.add(rest.resume(trials, true, 100.0, {0.0, "2026-01-01T00:00:00Z", 0.0}));
                base::Random random(6);
                VirtualClock clock;
                simulate_observer(rest, choices_from(study_, {}), random, clock, journal);
                EXPECT_EQ(store.sessions()[0].state, SessionState::kCompleted);
                EXPECT_EQ(store.trials().size(), whole_.size()) << "each pair once";
            }
        }
        fs::remove_all(place);
    }

    const stimuli::Study study_ = [] {
        stimuli::Study study = small_study(2);
        study.order = stimuli::OrderKind::kFixed;
        return study;
    }();
    tests::TemporaryFolder folder_;
    RecordedDisk disk_;
    std::map<std::string, std::string> before_;
    std::vector<TrialRecord> whole_;
    std::set<std::size_t> found_;
    int cuts_ = 0;
};

TEST_F(PowerCut, AtAnyWriteKeepsEveryAnswerThatWasSavedOnceAndTheSessionGoesOn) {
    play();
    ASSERT_EQ(whole_.size(), 2U);
    const std::size_t all = disk_.steps().size();
    ASSERT_GT(all, 60U) << "the record has the writes";
    for (std::size_t steps = 0; steps <= all; ++steps) {
        expect_sound_after(steps, Unsynced::kAll);
        expect_sound_after(steps, Unsynced::kNone);
        expect_sound_after(steps, Unsynced::kSome);
    }
    EXPECT_EQ(found_.size(), 3U) << "cut before, between and after the answers";
    RecordProperty("cuts", cuts_);
}

}  // namespace
}  // namespace obscura::app::kiosk
