// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/store/store.h"
#include "app/kiosk/screens.h"
#include "stimuli/order/order.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// How a study's sessions stand, with nothing that says who took part.
struct OperatorReport {
    int completed = 0;
    int open = 0;
    int abandoned = 0;
    stimuli::SessionOrder next;    ///< whoever comes next
    std::uint64_t to_balance = 0;  ///< completed sessions that are missing to a whole block
    // Of the completed ones.
    int checks = 0;
    int checks_right = 0;
    int repeats = 0;
    int repeats_alike = 0;
    std::vector<analysis::SessionRecord> sessions;  ///< latest first
};

[[nodiscard]] OperatorReport operator_report(analysis::Store& store, const stimuli::Study& study);

/// What the operator is asked about a session that was cut off: of the pairs that count, practice
/// left out, how many have all their answers. Throws as Procedure::resume() where it cannot go on
/// by that plan.
[[nodiscard]] CutOffSession cut_off_session(const stimuli::Study& study, const SessionPlan& plan,
                                            const analysis::SessionRecord& session,
                                            const std::vector<analysis::TrialRecord>& trials,
                                            const std::vector<analysis::EventRecord>& events);

}  // namespace obscura::app::kiosk
