// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/kiosk/kiosk.h"
#include "app/kiosk/timing.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// A self-test with every measurement, in order.
struct SelfTestRun {
    SelfTest test;
    std::vector<double> error_ms;
    std::vector<double> key_to_swap_ms;
};

/// Shows noise of the size of the study's images and grey in turn, `alternations` times, as a
/// session shows images and the interval; then answers keys. A key is an event that another thread
/// posts to the window; what a keyboard and its driver add, only an instrument outside can measure.
/// Throws as run_kiosk does where there is no such window.
[[nodiscard]] SelfTestRun run_self_test(const stimuli::Study& study, const KioskOptions& options,
                                        int alternations);

}  // namespace obscura::app::kiosk
