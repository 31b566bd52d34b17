// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/kiosk/window.h"

namespace obscura::app::kiosk {

/// How frames reach the screen.
struct Pace {
    double period_s = 0.0;    ///< of the display's refresh
    double measured_s = 0.0;  ///< between two frames handed over one after the other, median
    bool locked = false;      ///< presenting waits for the refresh
    /// A frame that is to be visible at a time is handed over this much earlier: half a period
    /// where presenting waits, so that the refresh nearest to that time shows it; else nothing.
    [[nodiscard]] double lead_s() const { return locked ? 0.5 * period_s : 0.0; }
};

/// The pace that the times between presented frames show, given the rate that the monitor tells
/// (0: unknown, 60 Hz is taken). Locked means that their median is that period within 10 % and
/// that the middle 80 % of them lie within 20 % of it.
[[nodiscard]] Pace pace_of(std::vector<double> intervals_s, double refresh_hz);

/// Presents some grey frames and times them.
[[nodiscard]] Pace measure_pace(Window& window, int grey_level);

/// Whole periods by which a frame came later than the first chance after it was asked for.
[[nodiscard]] int dropped_frames(const Pace& pace, double asked_s, double onset_s);

}  // namespace obscura::app::kiosk
