// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/operator_report.h"

#include <algorithm>
#include <map>

namespace obscura::app::kiosk {
namespace {

using analysis::SessionState;
using analysis::TrialRecord;

void count_attention(const std::vector<TrialRecord>& trials, OperatorReport& report) {
    std::map<std::string, bool> chose_a;
    for (const TrialRecord& trial : trials) chose_a[trial.condition] = trial.is_A_selected;
    for (const TrialRecord& trial : trials) {
        if (trial.expected != '\0') {
            ++report.checks;
            if (trial.is_A_selected == (trial.expected == 'A')) ++report.checks_right;
        }
        const auto original = chose_a.find(trial.repeats);
        if (trial.repeats.empty() || original == chose_a.end()) continue;
        ++report.repeats;
        if (original->second == trial.is_A_selected) ++report.repeats_alike;
    }
}

}  // namespace

OperatorReport operator_report(analysis::Store& store, const stimuli::Study& study) {
    OperatorReport report;
    for (analysis::SessionRecord& session : store.sessions()) {
        if (session.study != study.name || session.kind != analysis::Kind::kParticipant) continue;
        report.sessions.push_back(std::move(session));
    }
    std::reverse(report.sessions.begin(), report.sessions.end());
    for (const analysis::SessionRecord& session : report.sessions) {
        if (session.state == SessionState::kOpen) ++report.open;
        if (session.state == SessionState::kAbandoned) ++report.abandoned;
        if (session.state != SessionState::kCompleted) continue;
        ++report.completed;
        count_attention(store.trials_of(session.session_id), report);
    }
    const auto taken = store.taken_slots(study.name, study.seed, analysis::Kind::kParticipant);
    report.next = study.session_order(stimuli::next_slot(taken));
    const std::uint64_t block = stimuli::block_size(study.order, study.pair_count());
    const auto completed = static_cast<std::uint64_t>(report.completed);
    report.to_balance = (block - completed % block) % block;
    return report;
}

CutOffSession cut_off_session(const stimuli::Study& study, const SessionPlan& plan,
                              const analysis::SessionRecord& session,
                              const std::vector<TrialRecord>& trials,
                              const std::vector<analysis::EventRecord>& events) {
    Procedure rest(study, plan);
    (void)rest.resume(trials, true, 0.0, {0.0, session.started_utc}, events);
    const Progress at = rest.progress();
    return {.session_id = session.session_id,
            .started_utc = session.started_utc,
            .answered = at.practice ? 0 : at.pair,
            .count = session.condition_count,
            .refusal = ""};
}

}  // namespace obscura::app::kiosk
