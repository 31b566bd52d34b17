// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/recording.h"

#include <algorithm>
#include <exception>

#include "renderer/base/error.h"
#include "stimuli/order/order.h"

namespace obscura::app::kiosk {
namespace {

struct Commit {
    analysis::Store& store;

    void operator()(const BeginSession& row) const {
        store.begin_session(row.participant, row.session, row.events);
    }
    void operator()(const analysis::TrialRecord& row) const { store.add_trial(row); }
    void operator()(const CompleteSession& row) const {
        store.complete_session(row.session_id, row.ended_utc);
    }
    void operator()(const analysis::EventRecord& row) const { store.add_event(row); }
};

/// Whether the row is in the store. An event may stand there twice; that harms nobody.
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
    bool operator()(const analysis::EventRecord&) const { return false; }

    [[nodiscard]] bool has_session(const std::string& id,
                                   std::optional<analysis::SessionState> state) const {
        const auto sessions = store.sessions();
        return std::any_of(sessions.begin(), sessions.end(), [&](const auto& session) {
            return session.session_id == id && (!state || session.state == *state);
        });
    }
};

[[nodiscard]] BeginSession with_order(BeginSession row, const stimuli::SessionOrder& order) {
    row.session.slot = order.slot;
    row.session.latin_square = order.latin_square;
    row.session.latin_row = order.latin_row;
    row.session.swapped = order.swapped;
    return row;
}

/// The next free slot where another session holds that of `session`; nothing where none does or
/// the store cannot be read.
[[nodiscard]] std::optional<std::uint64_t> slot_instead(analysis::Store& store,
                                                        const analysis::SessionRecord& session) {
    try {
        const auto sessions = store.sessions();
        const bool taken = std::any_of(sessions.begin(), sessions.end(), [&](const auto& other) {
            return other.session_id != session.session_id && other.study == session.study &&
                   other.seed == session.seed && other.kind == session.kind &&
                   other.slot == session.slot && other.state != analysis::SessionState::kAbandoned;
        });
        if (!taken) return std::nullopt;
        return stimuli::next_slot(store.taken_slots(session.study, session.seed, session.kind));
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

/// False also where the store cannot be read: then the reason of the failed try matters.
[[nodiscard]] bool is_known_to_be_committed(analysis::Store& store, const Row& row) {
    try {
        return std::visit(IsCommitted{store}, row);
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace

void commit(analysis::Store& store, const Row& row) {
    try {
        std::visit(Commit{store}, row);
    } catch (...) {
        if (is_known_to_be_committed(store, row)) return;
        throw;
    }
}

namespace {

/// The procedure's order holds, not that of the row: an earlier try may have changed it.
void commit_begin(analysis::Store& store, const stimuli::Study& study, Procedure& procedure,
                  const BeginSession& row) {
    while (true) {
        const BeginSession planned = with_order(row, procedure.plan().order);
        try {
            commit(store, planned);
            return;
        } catch (const base::Error&) {
            const auto slot = slot_instead(store, planned.session);
            if (!slot) throw;
            procedure.change_order(study.session_order(*slot));
        }
    }
}

}  // namespace

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
