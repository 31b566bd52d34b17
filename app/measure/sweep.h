// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/measurement/report.h"
#include "app/measure/measured_scene.h"
#include "app/measure/timing.h"

namespace obscura::app {

/// A setting to measure on a view.
struct Setting {
    renderer::Variant choice;
    double truth_radius_m = 0.5;  ///< R of the truth it is held against
    Values values = Values::kPublished;
    std::string shown;  ///< where the study shows it, or what it is a fit of
};

/// Conditions and sides of the study that show just this setting on the view: `III a, V b`.
[[nodiscard]] std::string shown_where(const MeasuredView& view, const renderer::Variant& choice);

/// What the sweep of a view gives.
struct SweptView {
    std::vector<analysis::MeasurementRow> rows;  ///< one a setting
    /// Of the settings that the study shows, each with the index of its row; without names yet.
    std::vector<std::pair<std::size_t, analysis::ErrorMap>> maps;
    /// Of each setting: median milliseconds of the frame's other passes, by name.
    std::vector<std::map<std::string, double>> house_ms;
};

/// Who wants to know how far the sweep of a view is; `what` names view and setting.
struct SweepWatcher {
    /// A setting's first image is compared; to run it again takes that long.
    std::function<void(const std::string& what, double again_ms)> image;
    std::function<void(const std::string& what)> run;  ///< a setting was run again
};

/// Renders every setting, compares its accessibility with the truth (surfaces only, because empty
/// pixels are 1 in both), and then runs its accessibility pass and filter again, one setting after
/// the other and then all again (A B A B): kDiscardedRuns in all are thrown away, request.runs are
/// timed. The other passes of a frame are timed as often, once for all settings that have the same.
[[nodiscard]] SweptView sweep(MeasuredScene& stage, const MeasureRequest& request,
                              const MeasuredView& view, const std::vector<Setting>& settings,
                              const TimerCheck& timers, const SweepWatcher& watcher);

/// The share of width and height at each side that the interior error leaves out.
inline constexpr double kInteriorMargin = 0.1;

/// 1 where the truth and, if the frame has a depth buffer of the image's size, the frame too show a
/// surface; where blended surfaces occlude, the same one.
[[nodiscard]] std::vector<std::uint8_t> surface_mask(const renderer::Frame& frame,
                                                     const renderer::ReferenceImage& truth);

}  // namespace obscura::app
