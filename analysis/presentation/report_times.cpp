// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"

namespace obscura::analysis {
namespace {

constexpr std::int32_t kMostPositions = 60;

void add_row(IntervalPlot& plot, PageTable& table, const std::string& name, std::size_t group,
             const Quartiles& seconds, const std::string& interval) {
    plot.rows.push_back({name, fmt::format("{:.2f} s", seconds.median), group, true, seconds.median,
                         seconds.first, seconds.third});
    table.rows.push_back({name, std::to_string(seconds.n), fmt::format("{:.2f}", seconds.first),
                          fmt::format("{:.2f}", seconds.median),
                          fmt::format("{:.2f}", seconds.third), interval});
}

std::string seconds_cell(const Possible<Interval>& interval) {
    if (!interval.has_value()) return kNoValue;
    return fmt::format("{:.2f} to {:.2f}", interval->low, interval->high);
}

/// Response times by the number of the trial in its session.
std::vector<std::pair<std::int32_t, Quartiles>> by_position(const Tally& tally) {
    std::map<std::int32_t, std::vector<double>> times;
    for (const ConditionVotes& condition : tally.conditions) {
        for (const Answer& answer : condition.answers) {
            if (answer.position < 0 || answer.response_time_s <= 0.0) continue;
            times[answer.position].push_back(answer.response_time_s);
        }
    }
    std::vector<std::pair<std::int32_t, Quartiles>> rows;
    for (auto& [position, sample] : times) {
        const Possible<Quartiles> found = quartiles(sample);
        if (position < kMostPositions && found.has_value()) rows.emplace_back(position, *found);
    }
    return rows;
}

std::string trend_words(const Learning& learning) {
    std::string text;
    if (!learning.time.has_value()) {
        text = fmt::format("Whether answers became faster is not known: {}.", learning.time.reason);
    } else {
        const TimeTrend& trend = *learning.time;
        const bool has_interval = trend.interval.has_value();
        text = fmt::format("From one trial to the next the response time changes by {:+.3f} s{}.",
                           trend.slope_s,
                           has_interval ? fmt::format(" (95 % interval {:+.3f} to {:+.3f})",
                                                      trend.interval->low, trend.interval->high)
                                        : "");
        if (has_interval) {
            text += trend.interval->high < 0.0  ? " Participants became faster."
                    : trend.interval->low > 0.0 ? " Participants became slower."
                                                : " There is no sign that they sped up or tired.";
        }
    }
    if (!learning.choice.has_value()) {
        return text + fmt::format(
                          " Whether the choice itself changed over the session is not known: "
                          "{}.",
                          learning.choice.reason);
    }
    const StratifiedSlope& slope = *learning.choice;
    return text +
           fmt::format(
               " The log odds of choosing B change by {:+.3f} a trial (standard error {:.3f}, "
               "likelihood ratio {:.2f}, df 1, {}): {}.",
               slope.slope, slope.standard_error, slope.likelihood_ratio.statistic,
               p_words(slope.likelihood_ratio.p),
               slope.likelihood_ratio.p.p < kSignificance
                   ? "the preference drifted over the session"
                   : "no sign that the preference drifted over the session");
}

void add_learning(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("Did that change over the session?", 3);
    if (!analysis.learning.has_value()) {
        draft.page.paragraph(fmt::format("Not known: {}.", analysis.learning.reason));
        return;
    }
    draft.page.paragraph(trend_words(*analysis.learning));
    IntervalPlot plot;
    plot.name = "learning";
    plot.title = "Response time over the session";
    plot.axis = "seconds from question to answer: median and quartiles";
    PageTable table{{"Trial", "Answers", "First quartile (s)", "Median (s)", "Third quartile (s)"},
                    {}};
    for (const auto& [position, seconds] : by_position(analysis.tally)) {
        add_row(plot, table, fmt::format("trial {}", position + 1), 0, seconds, "");
        table.rows.back().pop_back();
    }
    if (plot.rows.empty()) return;
    draft.plot(interval_plot(plot), "Response times by the place of the trial in its session.");
    draft.page.table(table, "The same in numbers.");
}

}  // namespace

void add_response_times(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("How long did they take?");
    if (!analysis.response_times.has_value()) {
        draft.page.paragraph(fmt::format("Not known: {}.", analysis.response_times.reason));
        return;
    }
    const ResponseTimes& times = *analysis.response_times;
    IntervalPlot plot;
    plot.name = "times";
    plot.title = "Response time";
    plot.axis = "seconds from question to answer: median and quartiles of participants";
    plot.groups = {"one condition", "all together"};
    PageTable table{{"Condition", "Participants", "First quartile (s)", "Median (s)",
                     "Third quartile (s)", "95 % interval of the median (s)"},
                    {}};
    for (std::size_t i = 0; i < times.by_condition.size(); ++i) {
        const Possible<ResponseTimeSummary>& summary = times.by_condition[i];
        if (!summary.has_value()) continue;
        add_row(plot, table, analysis.conditions[i].condition.id, 0, summary->seconds,
                seconds_cell(summary->median_interval));
    }
    add_row(plot, table, "all", 1, times.overall.seconds,
            seconds_cell(times.overall.median_interval));
    draft.plot(
        interval_plot(plot),
        "Time from the question to the answer, not counting the time for which the images were "
        "looked at.");
    draft.page.table(table,
                     "The same in numbers. Each participant gives one time, the median of "
                     "that participant's own.");
    add_learning(draft);
}

}  // namespace obscura::analysis
