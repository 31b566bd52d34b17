// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/measurement/report.h"
#include "app/measure/measured_scene.h"
#include "app/measure/timing.h"

namespace obscura::app {

/// Runs the request's experiment on the first view of each scene: rows, and findings in sentences.
/// Gives what is to be said of how they came. Throws failure when interrupted.
[[nodiscard]] std::vector<std::string> run_experiment(MeasuredScene& stage,
                                                      const MeasureRequest& request,
                                                      const stimuli::Study& study,
                                                      const std::vector<MeasuredView>& views,
                                                      const TimerCheck& timers,
                                                      analysis::MeasurementReport& report);

}  // namespace obscura::app
