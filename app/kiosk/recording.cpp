// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/recording.h"

#include <algorithm>

namespace obscura::app::kiosk {
namespace {

struct Commit {
    analysis::Store& store;

    void operator()(const BeginSession& row) const {
        store.begin_session(row.participant, row.session);
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

}  // namespace

void commit(analysis::Store& store, const Row& row) {
    try {
        std::visit(Commit{store}, row);
    } catch (...) {
        if (std::visit(IsCommitted{store}, row)) return;
        throw;
    }
}

Journal journal_to(analysis::Store& store) {
    return Journal([&store](const Row& row) { commit(store, row); });
}

}  // namespace obscura::app::kiosk
