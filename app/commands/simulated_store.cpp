// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/simulated_store.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/store/store.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "app/kiosk/store_lock.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;
using analysis::Kind;
using analysis::Store;

/// What SQLite keeps beside a store while it is open; it must not outlive its store.
void remove_log(const fs::path& file) {
    for (const char* ending : {"-wal", "-shm", "-journal"}) fs::remove(file.string() + ending);
}

[[nodiscard]] kiosk::SessionPlan plan_of(const stimuli::Study& study,
                                         const stimuli::Manifest& manifest,
                                         const stimuli::Questions& questions, std::uint64_t slot) {
    kiosk::SessionPlan plan;
    plan.participant_id = fmt::format("simulated-p{:04}", slot + 1);
    plan.session_id = fmt::format("simulated-s{:04}", slot + 1);
    plan.kind = Kind::kSimulated;
    plan.images = kiosk::images_of(study, manifest);
    plan.order = study.session_order(slot);
    plan.questions = questions;
    plan.machine = kiosk::simulated_machine();
    return plan;
}

/// Every observer into a new store, in which each takes the next slot.
void simulate(const stimuli::Study& study, const stimuli::Manifest& manifest,
              const kiosk::ChoiceModel& choices, const Simulation& simulation,
              const fs::path& file) {
    Store store(store_url_of(file), Store::Access::kThrowaway);
    kiosk::VirtualClock clock;
    base::Progress progress("simulate", static_cast<std::size_t>(simulation.participants),
                            simulation.quiet);
    for (std::uint64_t slot = 0; slot < static_cast<std::uint64_t>(simulation.participants);
         ++slot) {
        kiosk::Procedure procedure(study, plan_of(study, manifest, simulation.questions, slot));
        kiosk::Journal journal = kiosk::journal_to(store);
        base::Random random(kiosk::observer_seed(simulation.seed, slot + 1));
        kiosk::simulate_observer(procedure, choices, random, clock, journal);
        progress.step(fmt::format("observer {}", slot + 1));
    }
}

}  // namespace

std::string store_url_of(const fs::path& file) { return "sqlite3://" + file.string(); }

void refuse_real_answers(const fs::path& file, const std::string& option) {
    // An empty file, of a program that ended before it made its tables, holds nobody's answers.
    if (!fs::exists(file) || fs::file_size(file) == 0) return;
    Store store(store_url_of(file), Store::Access::kReadOnly);
    const auto sessions = store.sessions();
    const bool simulated = std::all_of(sessions.begin(), sessions.end(), [](const auto& session) {
        return session.kind == Kind::kSimulated;
    });
    if (!simulated) {
        throw base::bad_input(
            "{}: {} holds answers of participants; simulated ones replace their store, give it "
            "another place",
            option, file.string());
    }
}

/// Beside and renamed: an interrupted simulation leaves the store of the last one.
void simulate_into_store(const stimuli::Study& study, const stimuli::Manifest& manifest,
                         const kiosk::ChoiceModel& choices, const Simulation& simulation) {
    const fs::path& file = simulation.file;
    // Nobody's answers may come in between the question and the replacement.
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    const kiosk::StoreLock lock(store_url_of(file));
    refuse_real_answers(file, simulation.option);
    const fs::path beside = file.string() + ".new";
    fs::remove(beside);
    remove_log(beside);
    simulate(study, manifest, choices, simulation, beside);
    remove_log(file);
    fs::rename(beside, file);
}

}  // namespace obscura::app
