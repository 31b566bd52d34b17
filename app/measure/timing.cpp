// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/gl/context.h"

namespace obscura::app {
namespace {

constexpr double kLongPass_ms = 20.0;
constexpr int kLargestSide_px = 4096;

}  // namespace

TimerCheck judge_timers(double clock_ms, double query_ms, bool software) {
    TimerCheck check{false, clock_ms, query_ms, ""};
    const double apart = clock_ms > 0.0 ? std::abs(query_ms - clock_ms) / clock_ms : 1.0;
    const bool agree = apart <= kTimerTolerance;
    check.use_queries = agree && !software && clock_ms >= kLongPass_ms;
    std::string why = "they agree, so the queries are used";
    if (software) {
        why = "this is a software renderer, so glFinish and the clock are used";
    } else if (!agree) {
        why = "they disagree by more than 10 %, so glFinish and the clock are used";
    } else if (!check.use_queries) {
        why =
            "no pass took 20 ms, so they could not be held against each other, and glFinish and "
            "the clock are used";
    }
    check.sentence = fmt::format(
        "Check of the timers: a pass of {:.2f} ms by the clock takes {:.2f} ms by the driver's "
        "timestamp queries ({:.1f} % apart); {}.",
        clock_ms, query_ms, 100.0 * apart, why);
    return check;
}

TimerCheck check_timers(MeasuredScene& stage, const MeasuredView& view,
                        const renderer::Variant& choice) {
    double clock_ms = 0.0;
    double query_ms = 0.0;
    for (int side = 256; side <= kLargestSide_px; side *= 2) {
        for (int run = 0; run <= kDiscardedRuns; ++run) {
            const renderer::Frame frame = stage.render_plainly(view, choice, side, side);
            clock_ms = query_ms = 0.0;
            for (const renderer::PassTime& time : frame.times) {
                if (time.phase != renderer::Phase::kTechnique) continue;
                clock_ms += time.milliseconds;
                query_ms += time.query_milliseconds;
            }
        }
        if (clock_ms >= kLongPass_ms) break;
    }
    return judge_timers(clock_ms, query_ms, renderer::is_software_renderer());
}

void RunTimes::add(const std::vector<renderer::PassTime>& passes, bool use_queries) {
    double accessibility = 0.0;
    double denoise = 0.0;
    for (const renderer::PassTime& time : passes) {
        const double spent_ms = use_queries ? time.query_milliseconds : time.milliseconds;
        if (!is_of_the_variant(time.phase)) continue;
        const bool before =
            time.phase == renderer::Phase::kSeen || time.phase == renderer::Phase::kTechnique;
        (before ? accessibility : denoise) += spent_ms;
    }
    accessibility_ms_.push_back(accessibility);
    denoise_ms_.push_back(denoise);
    both_ms_.push_back(accessibility + denoise);
}

void RunTimes::put(analysis::MeasurementRow& row, const std::vector<double>& others_ms) const {
    std::vector<double> frame_ms;
    for (std::size_t i = 0; i < std::min(both_ms_.size(), others_ms.size()); ++i) {
        frame_ms.push_back(both_ms_[i] + others_ms[i]);
    }
    row.accessibility = analysis::summary_of(accessibility_ms_);
    row.filter = analysis::summary_of(denoise_ms_);
    row.cost = analysis::summary_of(both_ms_);
    row.frame = analysis::summary_of(frame_ms);
    row.runs = static_cast<int>(both_ms_.size());
}

double others_ms(const renderer::Frame& frame, bool use_queries) {
    double sum_ms = 0.0;
    for (const renderer::PassTime& time : frame.times) {
        if (is_of_the_variant(time.phase)) continue;
        sum_ms += use_queries ? time.query_milliseconds : time.milliseconds;
    }
    return sum_ms;
}

}  // namespace obscura::app
