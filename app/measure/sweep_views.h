// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/measure/sweep.h"

namespace obscura::app {

/// What follows an interruption.
inline constexpr const char* kGoesOn = "they are kept, and the same command goes on from there";

/// The views that were swept, in order: all, or those that were finished before Ctrl-C.
struct SweptViews {
    std::vector<SweptView> views;
    bool interrupted = false;
    std::vector<std::string> notes;  ///< which are of a run before, which are missing
};

/// Sweeps each view with its settings and says how far it is under `title`. A view that a run
/// before finished, which did not come to its end, is taken from the request's `kept_views`; when
/// all are finished, none is kept. Throws failure when interrupted before the first is finished.
[[nodiscard]] SweptViews sweep_views(MeasuredScene& stage, const MeasureRequest& request,
                                     const std::string& title,
                                     const std::vector<MeasuredView>& views,
                                     const std::vector<std::vector<Setting>>& settings,
                                     const TimerCheck& timers);

}  // namespace obscura::app
