// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/measurement/row.h"
#include "app/measure/measured_scene.h"

namespace obscura::app {

/// Which of the two ways to time a pass is right here, and how that was found out.
struct TimerCheck {
    bool use_queries = false;  ///< else glFinish and the clock
    double clock_ms = 0.0;
    double query_ms = 0.0;
    std::string sentence;

    [[nodiscard]] std::string timer() const { return use_queries ? "queries" : "clock"; }
};

/// The largest disagreement of timestamp queries with the clock at which they are still used.
inline constexpr double kTimerTolerance = 0.1;

/// What the two times of a pass of more than 20 ms say. On a software renderer the clock is used
/// whatever they say.
[[nodiscard]] TimerCheck judge_timers(double clock_ms, double query_ms, bool software);

/// Enlarges the image until the technique's pass takes more than 20 ms by the clock, or as far as
/// 4096 pixels, and compares.
[[nodiscard]] TimerCheck check_timers(MeasuredScene& stage, const MeasuredView& view,
                                      const renderer::Variant& choice);

/// The times of several runs of one setting.
class RunTimes {
  public:
    /// One run's accessibility pass and filter; what else is among the passes is not counted.
    void add(const std::vector<renderer::PassTime>& passes, bool use_queries);
    /// Writes the summaries into the row. `others_ms`: the frame's other passes, run by run; the
    /// whole frame is their sum with the setting's own.
    void put(analysis::MeasurementRow& row, const std::vector<double>& others_ms) const;

  private:
    std::vector<double> accessibility_ms_;
    std::vector<double> denoise_ms_;
    std::vector<double> both_ms_;
};

/// Milliseconds of all passes but accessibility and its filter.
[[nodiscard]] double others_ms(const renderer::Frame& frame, bool use_queries);

}  // namespace obscura::app
