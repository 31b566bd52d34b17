// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/measurement/growth.h"
#include "app/measure/measured_scene.h"
#include "app/measure/timing.h"

namespace obscura::app {

/// How the accessibility pass of each technique grows with the image's pixels, at the descriptor's
/// samples, and with samples, at a fixed size: medians of runs after those that are discarded.
[[nodiscard]] std::vector<analysis::Growth> measure_growth(
    MeasuredScene& stage, const MeasureRequest& request, const MeasuredView& view,
    const TimerCheck& timers, const std::function<void(const std::string&)>& step);

/// How often measure_growth calls `step`.
[[nodiscard]] std::size_t growth_steps(const MeasureRequest& request);

}  // namespace obscura::app
