// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/run_experiment.h"

#include <fmt/format.h>

#include <cmath>

#include "app/measure/experiment.h"
#include "app/measure/hard_cases.h"
#include "app/measure/overview_of.h"
#include "app/measure/sweep_views.h"
#include "renderer/base/error.h"
#include "renderer/gl/context.h"

namespace obscura::app {
namespace {

using HouseTimes = std::vector<std::map<std::string, double>>;

/// The means of a setting's rows, `every` rows apart.
Outcome mean_of(const std::string& name, const std::vector<analysis::MeasurementRow>& rows,
                const HouseTimes& house_ms, std::size_t first, std::size_t every) {
    Outcome outcome{name};
    double square = 0.0;
    double count = 0.0;
    for (std::size_t i = first; i < rows.size(); i += every) {
        const analysis::MeasurementRow& row = rows[i];
        outcome.ao_ms += row.accessibility.median_ms;
        outcome.filter_ms += row.filter.median_ms;
        outcome.frame_ms += row.frame.median_ms;
        square += row.error.has_value() ? row.error->rmse * row.error->rmse : NAN;
        outcome.bias += row.error.has_value() ? row.error->bias : NAN;
        for (const auto& [pass, ms] : house_ms[i]) outcome.house_ms[pass] += ms;
        count += 1.0;
    }
    for (auto& [pass, ms] : outcome.house_ms) ms /= count;
    for (double* sum : {&outcome.ao_ms, &outcome.filter_ms, &outcome.frame_ms, &outcome.bias}) {
        *sum /= count;
    }
    outcome.rmse = std::sqrt(square / count);
    return outcome;
}

std::string in_a_sentence(const Outcome& outcome) {
    const std::string times =
        fmt::format("{}: {:.2f} ms, filter {:.2f} ms, frame {:.2f} ms", outcome.name, outcome.ao_ms,
                    outcome.filter_ms, outcome.frame_ms);
    return std::isnan(outcome.rmse)
               ? times + ", no accessibility and no error"
               : fmt::format("{}, RMSE {:.4f}, bias {:+.4f}", times, outcome.rmse, outcome.bias);
}

}  // namespace

std::vector<std::string> run_experiment(MeasuredScene& stage, const MeasureRequest& request,
                                        const stimuli::Study& study,
                                        const std::vector<MeasuredView>& views,
                                        const TimerCheck& timers,
                                        analysis::MeasurementReport& report) {
    const Experiment& experiment = *find_experiment(request.experiment);
    const std::vector<MeasuredView> each = one_a_scene(views);
    report.title = experiment.title;
    std::vector<std::vector<Setting>> settings(each.size());
    for (std::size_t i = 0; i < each.size(); ++i) {
        for (const Experiment::Setting& setting : experiment.settings) {
            const renderer::Variant variant = on_view(setting.variant, each[i], study);
            settings[i].push_back({variant, truth_radius_m(each[i], variant), setting.values, ""});
        }
    }
    SweptViews swept = sweep_views(stage, request, experiment.name, each, settings, timers);
    if (swept.interrupted) {
        throw base::failure("{}, which say nothing without the others; {}", swept.notes.back(),
                            kGoesOn);
    }
    HouseTimes house_ms;
    for (SweptView& view : swept.views) {
        for (auto& row : view.rows) report.rows.push_back(std::move(row));
        for (auto& ms : view.house_ms) house_ms.push_back(std::move(ms));
    }
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < experiment.settings.size(); ++i) {
        outcomes.push_back(mean_of(experiment.settings[i].name, report.rows, house_ms, i,
                                   experiment.settings.size()));
        if (!experiment.overview) report.findings.push_back(in_a_sentence(outcomes.back()));
    }
    if (experiment.overview) {
        report.overview =
            overview_of(report.rows, experiment.settings,
                        count_hard_cases(techniques_of(experiment.settings), request.quiet));
    }
    const std::vector<Finding> findings =
        experiment.judge != nullptr ? experiment.judge(outcomes) : std::vector<Finding>{};
    for (const Finding& finding : findings) {
        const char* const here = finding.is_undecided() ? "undecided, less than 5 % apart"
                                 : finding.agrees       ? "too"
                                                        : "not";
        report.findings.push_back(
            fmt::format("The paper: {}. Here {}: {}.", finding.conclusion, here, finding.because));
    }
    if (!experiment.silent_on.empty()) {
        report.findings.push_back("Not judged: " + experiment.silent_on + ".");
    }
    if (renderer::is_software_renderer()) {
        report.findings.push_back(
            "Times are of a software renderer: what a paper concludes from the bandwidth or the "
            "caches of a GPU they neither confirm nor deny.");
    }
    analysis::name_variants_apart(report.rows);
    analysis::mark_front(report.rows);
    return swept.notes;
}

}  // namespace obscura::app
