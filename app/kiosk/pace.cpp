// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/pace.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/quantile.h"
#include "app/kiosk/stimulus_view.h"

namespace obscura::app::kiosk {
namespace {

constexpr double kUsualRefresh_hz = 60.0;
constexpr double kMedianTolerance = 0.1;
constexpr double kSpreadTolerance = 0.2;
constexpr int kFrames = 24;
/// A frame asked for at a refresh and shown at the next is not late, whatever the clock's jitter.
constexpr double kJitter = 0.1;

}  // namespace

Pace pace_of(std::vector<double> intervals_s, double refresh_hz) {
    Pace pace;
    pace.period_s = 1.0 / (refresh_hz > 0.0 ? refresh_hz : kUsualRefresh_hz);
    if (intervals_s.empty()) return pace;
    std::sort(intervals_s.begin(), intervals_s.end());
    pace.measured_s = analysis::quantile_of_sorted(intervals_s, 0.5);
    const double off = std::abs(pace.measured_s - pace.period_s);
    const double spread = analysis::quantile_of_sorted(intervals_s, 0.9) -
                          analysis::quantile_of_sorted(intervals_s, 0.1);
    pace.locked =
        off <= kMedianTolerance * pace.period_s && spread <= kSpreadTolerance * pace.period_s;
    return pace;
}

Pace measure_pace(Window& window, int grey_level) {
    std::vector<double> intervals_s;
    double last_s = 0.0;
    for (int frame = 0; frame < kFrames; ++frame) {
        draw_grey(window.size(), grey_level);
        const double onset_s = window.present();
        // The first frames fill the driver's queue.
        if (frame > 3) intervals_s.push_back(onset_s - last_s);
        last_s = onset_s;
        window.poll_events();
    }
    return pace_of(std::move(intervals_s), window.refresh_hz());
}

int dropped_frames(const Pace& pace, double asked_s, double onset_s) {
    const double periods = (onset_s - asked_s) / pace.period_s - 1.0 - kJitter;
    return periods > 0.0 ? static_cast<int>(std::ceil(periods)) : 0;
}

}  // namespace obscura::app::kiosk
