// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/recording.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <optional>

#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "stimuli/order/order.h"

namespace obscura::app::kiosk {
namespace {

struct Commit {
    analysis::Store& store;

    void operator()(const BeginSession& row) const {
        (void)store.begin_session(row.participant, row.session, row.events);
    }
    void operator()(const analysis::TrialRecord& row) const { store.add_trial(row); }
    void operator()(const CompleteSession& row) const {
        store.complete_session(row.session_id, row.ended_utc);
    }
    void operator()(const analysis::EventRecord& row) const { store.add_event(row); }
};

/// Whether the row is in the store.
struct IsCommitted {
    analysis::Store& store;

    bool operator()(const BeginSession& row) const {
        return has_session(row.session.session_id, std::nullopt);
    }
    bool operator()(const analysis::TrialRecord& row) const {
        const auto trials = store.trials_of(row.session_id);
        return std::any_of(trials.begin(), trials.end(), [&](const auto& trial) {
            return trial.trial_index == row.trial_index && trial.answered_utc == row.answered_utc &&
                   trial.is_A_selected == row.is_A_selected;
        });
    }
    bool operator()(const CompleteSession& row) const {
        return has_session(row.session_id, analysis::SessionState::kCompleted);
    }
    bool operator()(const analysis::EventRecord& row) const {
        const auto events =
            row.session_id.empty() ? store.other_events() : store.events_of(row.session_id);
        return std::find(events.begin(), events.end(), row) != events.end();
    }

    [[nodiscard]] bool has_session(const std::string& id,
                                   std::optional<analysis::SessionState> state) const {
        const auto sessions = store.sessions();
        return std::any_of(sessions.begin(), sessions.end(), [&](const auto& session) {
            return session.session_id == id && (!state || session.state == *state);
        });
    }
};

void set_order(analysis::SessionRecord& session, const stimuli::SessionOrder& order) {
    session.slot = order.slot;
    session.latin_square = order.latin_square;
    session.latin_row = order.latin_row;
    session.swapped = order.swapped;
}

enum class Outcome { kCommitted, kNotCommitted, kUnknown };

/// Of a try that failed. Unknown where the store cannot be read either.
[[nodiscard]] Outcome outcome_of(analysis::Store& store, const Row& row) {
    try {
        return std::visit(IsCommitted{store}, row) ? Outcome::kCommitted : Outcome::kNotCommitted;
    } catch (const std::exception&) {
        return Outcome::kUnknown;
    }
}

/// `work` brings the row to the store. Where it fails and the store answers all the same, as a
/// server does that was away for a moment, it is tried once more.
void commit_by(const std::function<void()>& work, analysis::Store& store, const Row& row) {
    try {
        work();
        return;
    } catch (...) {
        const Outcome outcome = outcome_of(store, row);
        if (outcome == Outcome::kCommitted) return;
        if (outcome == Outcome::kUnknown) throw;
    }
    work();
}

/// The session as the store has it, whose place in the order an earlier try may have moved.
[[nodiscard]] std::optional<std::uint64_t> slot_in(analysis::Store& store,
                                                   const std::string& session_id) {
    for (const auto& session : store.sessions()) {
        if (session.session_id == session_id) return session.slot;
    }
    return std::nullopt;
}

/// The procedure's order holds, not that of the row: an earlier try may have changed it.
void commit_begin(analysis::Store& store, const stimuli::Study& study, Procedure& procedure,
                  BeginSession row) {
    set_order(row.session, procedure.plan().order);
    std::uint64_t slot = row.session.slot;
    commit_by(
        [&] {
            slot = store.begin_session(
                row.participant, row.session, row.events,
                [&study](analysis::SessionRecord& session,
                         const std::vector<std::uint64_t>& taken) {
                    set_order(session, study.session_order(stimuli::next_slot(taken)));
                });
        },
        store, row);
    if (slot == row.session.slot) slot = slot_in(store, row.session.session_id).value_or(slot);
    if (slot != procedure.plan().order.slot) procedure.change_order(study.session_order(slot));
}

}  // namespace

void commit(analysis::Store& store, const Row& row) {
    commit_by([&] { std::visit(Commit{store}, row); }, store, row);
}

namespace {

/// To the server, after what waits for it here; or here, where it is away.
void commit_or_keep(analysis::Store& store, Spool& spool, const Row& row) {
    try {
        if (spool.waits()) spool.deliver(store);
        commit(store, row);
        spool.follow(row);
    } catch (const std::exception& error) {
        if (outcome_of(store, row) != Outcome::kUnknown) throw;
        base::log::warn("{}; {} is kept in {} until the server answers again", error.what(),
                        name_of(row), spool.file().string());
        spool.keep(row);
    }
}

}  // namespace

Journal journal_to(analysis::Store& store, const stimuli::Study& study, Procedure& procedure,
                   Spool& spool) {
    return Journal([&](const Row& row) {
        const auto* begin = std::get_if<BeginSession>(&row);
        if (begin == nullptr) {
            commit_or_keep(store, spool, row);
            return;
        }
        if (spool.waits()) spool.deliver(store);
        commit_begin(store, study, procedure, *begin);
        BeginSession begun = *begin;
        set_order(begun.session, procedure.plan().order);
        spool.follow(begun);
    });
}

Journal journal_to(analysis::Store& store) {
    return Journal([&store](const Row& row) { commit(store, row); },
                   [&store] { store.require_in_place(); });
}

Journal journal_to(analysis::Store& store, const stimuli::Study& study, Procedure& procedure) {
    return Journal(
        [&store, &study, &procedure](const Row& row) {
            if (const auto* begin = std::get_if<BeginSession>(&row)) {
                commit_begin(store, study, procedure, *begin);
            } else {
                commit(store, row);
            }
        },
        [&store] { store.require_in_place(); });
}

}  // namespace obscura::app::kiosk
