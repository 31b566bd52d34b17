// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "analysis/conclusions/preference_and_cost.h"
#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"

namespace obscura::analysis {
namespace {

/// A setting of a technique over all views that it was measured on.
struct Setting {
    std::string technique;
    int samples = 0;
    std::string denoise;
    int views = 0;
    int on_front = 0;  ///< views on whose front it is
    double ms = 0.0;   ///< means over the views
    double rmse = 0.0;
};

using View = std::tuple<std::string, std::string, std::string>;

/// What is shown of a measurement: settings as published, at full size, of one device and size,
/// that were measured on every view.
struct Overview {
    std::vector<Setting> settings;  ///< by technique, then samples
    std::size_t views = 0;
    std::size_t left_out = 0;  ///< settings that were not measured on all views
};

Overview overview_of(const MeasurementTable& table, const PreferenceAndCost& joined) {
    std::set<View> views;
    std::map<std::tuple<std::string, int, std::string>, Setting> settings;
    for (const MeasuredSetting& row : table.rows) {
        if (row.fitted || row.ao_scale != 1.0 || row.device != joined.device ||
            row.width != joined.width || row.height != joined.height || !row.rmse.has_value() ||
            !row.ms_median.has_value()) {
            continue;
        }
        views.insert({row.scene, row.camera, row.validity});
        Setting& setting = settings[{row.technique, row.samples, row.denoise}];
        setting.technique = row.technique;
        setting.samples = row.samples;
        setting.denoise = row.denoise;
        ++setting.views;
        setting.on_front += row.on_front ? 1 : 0;
        setting.ms += *row.ms_median;
        setting.rmse += *row.rmse;
    }
    Overview overview;
    overview.views = views.size();
    for (auto& [key, setting] : settings) {
        // More rows than views: the same setting with other formats or noise; the mean holds them.
        if (setting.views < static_cast<int>(views.size())) {
            ++overview.left_out;
            continue;
        }
        setting.ms /= setting.views;
        setting.rmse /= setting.views;
        overview.settings.push_back(setting);
    }
    return overview;
}

Plot speed_plot(const Overview& overview) {
    CurvePlot plot;
    plot.name = "speed-error";
    plot.title = "Speed against error";
    plot.x_axis = "milliseconds a frame (median; technique and filter)";
    plot.y_axis = "RMSE of accessibility against the truth";
    // Nothing costs nothing, so a logarithmic axis is only for techniques that cost something.
    const bool is_logarithmic = std::all_of(overview.settings.begin(), overview.settings.end(),
                                            [](const Setting& one) { return one.ms > 0.0; });
    plot.extra = is_logarithmic ? "set logscale x\n" : "set xrange [0:*]\n";
    plot.extra += "set yrange [0:*]\nset offsets 0, graph 0.1, graph 0.05, 0\n";
    for (const Setting& setting : overview.settings) {
        if (plot.series.empty() || plot.series.back().title != setting.technique) {
            plot.series.push_back({setting.technique, {}, false, true, {}});
        }
        plot.series.back().points.emplace_back(setting.ms, setting.rmse);
        plot.series.back().labels.push_back(setting.samples == 0 ? ""
                                                                 : std::to_string(setting.samples));
    }
    return curve_plot(plot);
}

PageTable speed_table(const Overview& overview) {
    PageTable table{{"Technique", "Samples", "Filter", "Median (ms)", "RMSE", "On the front of"},
                    {}};
    for (const Setting& setting : overview.settings) {
        table.rows.push_back(
            {setting.technique, setting.samples == 0 ? kNoValue : std::to_string(setting.samples),
             setting.denoise.empty() ? kNoValue : setting.denoise,
             fmt::format("{:.3f}", setting.ms), fmt::format("{:.4f}", setting.rmse),
             fmt::format("{} of {}", setting.on_front, setting.views)});
    }
    return table;
}

}  // namespace

void add_speed_and_error(ReportDraft& draft) {
    const ReportInput& input = draft.input;
    draft.page.heading("Speed and error of the techniques");
    if (!input.measurement) {
        draft.page.paragraph(fmt::format("Not measured: {}.", input.measurement_unknown));
        return;
    }
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    const Overview overview = overview_of(*input.measurement, joined);
    if (overview.settings.empty()) {
        draft.page.paragraph(fmt::format("{} has no setting with both a time and an error.",
                                         input.measurement->source));
        return;
    }
    draft.page.paragraph(fmt::format(
        "Means over {} measured{}{}, parameters as published, buffers at full size. Nearer the "
        "lower "
        "left corner is better. {}",
        counted(static_cast<std::int64_t>(overview.views), "view"),
        joined.width > 0 ? fmt::format(" at {} × {}", joined.width, joined.height) : "",
        joined.device.empty() ? "" : fmt::format(" on {}", joined.device),
        overview.left_out == 0
            ? ""
            : fmt::format("{} not measured on every view {} left out.",
                          counted(static_cast<std::int64_t>(overview.left_out), "setting"),
                          overview.left_out == 1 ? "is" : "are")));
    draft.plot(speed_plot(overview),
               "Each point is a technique with a number of samples (written beside it).");
    draft.page.table(
        speed_table(overview),
        "On the front of: views on which no other setting is both faster and nearer the "
        "truth.");
}

void add_methods(ReportDraft& draft) {
    const Tally& tally = draft.input.analysis.tally;
    draft.page.heading("How this was computed");
    draft.page.list({
        fmt::format("Answers: {}{}.",
                    is_published_votes(tally) ? "Jakobsen 2010, Table 4, as built into this program"
                                              : tally.source,
                    tally.study.empty() ? "" : fmt::format(", study {}", tally.study)),
        "Conditions are compared within participants where each participant's answers are known "
        "(Cochran's Q, McNemar's test), else from counts. Votes that are pooled over conditions "
        "come "
        "from the same people, which tests of counts take as independent.",
        "Intervals: Wilson's score interval of a share, 95 %. Exact tests are two-sided, by the "
        "method "
        "of small p-values. Significant means p < 0.05.",
        "A dash means that there is no such number; the reason is in analysis.json under the same "
        "name. Numbers are rounded here and in full precision there.",
        "The folder plots/ holds each plot's data and gnuplot script, to be drawn anew.",
        fmt::format("Computed by Obscura {}.", OBSCURA_VERSION),
    });
}

}  // namespace obscura::analysis
