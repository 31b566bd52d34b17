// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/store/store.h"
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

}  // namespace obscura::app::kiosk
