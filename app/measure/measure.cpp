// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/measure.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <thread>
#include <utility>

#include "app/measure/fit_settings.h"
#include "app/measure/fitted_study.h"
#include "app/measure/growth.h"
#include "app/measure/hard_cases.h"
#include "app/measure/run_experiment.h"
#include "app/measure/sweep_views.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/frame/steps_by.h"
#include "renderer/gl/context.h"

namespace obscura::app {
namespace {

using renderer::Variant;

/// The study whose assumption of an order of accuracy the report looks at.
constexpr const char* kThesis = "jakobsen2010";

/// The views in an order that has those of one scene together.
std::vector<MeasuredView> by_scene(std::vector<MeasuredView> views) {
    std::vector<MeasuredView> ordered;
    for (const MeasuredView& view : views) {
        const auto last_of_scene =
            std::find_if(ordered.rbegin(), ordered.rend(),
                         [&](const MeasuredView& before) { return before.scene == view.scene; });
        ordered.insert(last_of_scene == ordered.rend() ? ordered.end() : last_of_scene.base(),
                       view);
    }
    return ordered;
}

bool can_be_fitted(const std::string& technique) {
    const renderer::Technique& descriptor = *renderer::find_technique(technique);
    return descriptor.samples.high > 0 && !descriptor.parameters.empty();
}

/// Each technique on each scene, in every way in which the study shows it there.
std::vector<FittedChoice> fit_all(MeasuredScene& stage, const MeasureRequest& request,
                                  const stimuli::Study& study,
                                  const std::vector<MeasuredView>& views) {
    const FitEffort effort = fit_effort(request);
    std::vector<FittedChoice> wanted;
    std::vector<const MeasuredView*> on;
    for (const MeasuredView& view : views) {
        for (const std::string& name : measured_techniques(request)) {
            if (!can_be_fitted(name)) continue;
            for (const Valued& way : published_choices(view, study, name)) {
                const bool there = std::any_of(
                    wanted.begin(), wanted.end(),
                    [&](const FittedChoice& fit) { return fit.is_for(*view.scene, way.choice); });
                if (there) continue;
                wanted.push_back({view.scene, way.choice, {}, {}});
                on.push_back(&view);
            }
        }
    }
    const auto trials = static_cast<std::size_t>(effort.search.scouts +
                                                 effort.search.starts * effort.search.evaluations);
    base::Progress progress("fit (at most)", wanted.size() * (trials + 1), request.quiet);
    std::vector<FittedChoice> fitted;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        fitted.push_back(
            fit_on_scene(stage, effort, views, *on[i], wanted[i].published,
                         [&progress](const std::string& what) { progress.step(what); }));
    }
    return fitted;
}

/// Settings that differ only in what a fit finds become one.
void add_fitted(std::vector<Setting>& settings, Setting setting) {
    for (Setting& known : settings) {
        if (known.values != Values::kFitted || known.choice != setting.choice) continue;
        if (!setting.shown.empty()) {
            known.shown += (known.shown.empty() ? "" : ", ") + setting.shown;
        }
        return;
    }
    settings.push_back(std::move(setting));
}

/// What is measured on a view: everything before any fit, and with fitted values the settings with
/// the filter of the fit and those that the study shows.
std::vector<Setting> all_settings(const MeasureRequest& request, const stimuli::Study& study,
                                  const MeasuredView& view,
                                  const std::vector<FittedChoice>& fitted) {
    std::vector<Setting> settings;
    for (const Valued& valued : settings_of(request, view, study)) {
        settings.push_back({valued.choice, truth_radius_m(view, valued.choice), valued.values,
                            shown_where(view, valued.choice)});
    }
    const std::size_t published = settings.size();
    for (const FittedChoice& fit : fitted) {
        for (std::size_t i = 0; i < published; ++i) {
            const Setting before = settings[i];
            if (!fit.is_for(*view.scene, before.choice)) continue;
            const bool as_fitted = before.choice.denoise == fit.choice.denoise &&
                                   renderer::same_options(before.choice, fit.choice);
            if (!as_fitted && before.shown.empty()) continue;
            Setting setting = before;
            setting.values = Values::kFitted;
            setting.choice.parameters = fit.choice.parameters;
            add_fitted(settings, std::move(setting));
        }
    }
    return settings;
}

std::vector<std::string> method_of(const MeasureRequest& request, const TimerCheck& timers) {
    return {
        fmt::format(
            "Images of {}x{} pixels; the truth is traced with {} rays a pixel from the "
            "geometric normal, within the setting's own radius before any fit (for a technique "
            "without one, the radius that the others have on that scene).",
            *request.width, *request.height, *request.rays),
        fmt::format(
            "The accessibility pass and the filter of each setting are run {} times, in turn "
            "with all other settings of the view; the first {} are thrown away. The other "
            "passes of a frame are timed {} times for all settings that have the same, and frame "
            "times are the sum. Times are of {}.",
            kDiscardedRuns + *request.runs, kDiscardedRuns, *request.runs,
            timers.use_queries ? "the driver's timestamp queries"
                               : "glFinish and a monotonic clock"),
        "Errors are of linear accessibility (1 = open) before any display curve, over the pixels "
        "that show a surface; empty pixels are 1 in both and do not count. The interior error "
        "leaves out a tenth of the image at each side.",
        "Where a camera comes with several levels of light, the first has every setting and the "
        "others what the study shows: light changes neither accessibility nor its time.",
        "Fetches a pixel are the most texture reads that accessibility pass and filter may make; "
        "raymarch stops at its first occluder.",
        "Final images are compared as sRGB code values / 255 (OpenImageIO's compare); the share "
        "that differs visibly is by Yee's metric at 100 cd/m2 and a field of view of 45 degrees.",
        "Values are published where the study gives them for that scene, standard where they are "
        "the technique's own, and start where they come from another scene, with other sizes: a "
        "fit would start there.",
        "Fitted values are the descriptor's continuous parameters, found by NLopt on cameras that "
        "are not reported on where the scene has such; the number of samples is never fitted."};
}

/// What the study shows and no row can hold is said.
void note_unmeasured(const stimuli::Study& study, Measured& measured) {
    for (const stimuli::Condition& condition : study.conditions) {
        for (const Variant* side : {&condition.a, &condition.b}) {
            const std::string why = why_unmeasured(*renderer::find_technique(side->technique));
            if (why.empty()) continue;
            measured.notes.push_back(fmt::format("condition {}: {} {}: it has no row", condition.id,
                                                 side->variant_name(), why));
        }
    }
}

/// How steps are run is said where a device gives a choice, and what runs elsewhere than the device
/// that the rows name.
void note_steps(const MeasureRequest& request, Measured& measured) {
    const renderer::StepsBy steps = renderer::steps_by_device();
    if (steps == renderer::StepsBy::kCompute) {
        measured.notes.push_back(fmt::format("techniques and filters run as {}", in_words(steps)));
        return;
    }
    for (const std::string& name : measured_techniques(request)) {
        if (!renderer::find_technique(name)->standard_recipe().on_processor()) continue;
        measured.notes.push_back(fmt::format(
            "{} traces its rays on the processor, on {} threads, whatever draws the rest", name,
            std::max(1U, std::thread::hardware_concurrency())));
    }
}

/// The setting that the timers are checked with: the most expensive technique's.
Variant heavy_choice(const MeasureRequest& request) {
    Variant choice;
    int most = -1;
    for (const std::string& name : measured_techniques(request)) {
        const renderer::Technique& technique = *renderer::find_technique(name);
        Variant candidate;
        candidate.technique = name;
        candidate.samples = technique.samples.standard;
        const int fetches = renderer::fetches_per_pixel(candidate);
        if (fetches > most) {
            most = fetches;
            choice = candidate;
        }
    }
    return choice;
}

/// Letters, figures and hyphens alone.
std::string file_stem(std::string text) {
    for (char& letter : text) {
        const bool safe = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                          (letter >= '0' && letter <= '9') || letter == '.';
        if (!safe) letter = '-';
    }
    return text;
}

/// Names a map after its row, unlike any name before.
void name_map(analysis::ErrorMap& map, const analysis::MeasurementRow& row,
              std::set<std::string>& taken) {
    std::string setting = row.variant;
    if (row.denoise != kPlottedFilter && row.samples > 0) setting += ' ' + row.denoise;
    if (!row.options.empty()) setting += ' ' + row.options;
    const std::string name = file_stem(fmt::format("error-{}-{}-{}{}", row.scene_id, row.camera,
                                                   setting, row.fitted ? "-fitted" : ""));
    map.name = name;
    for (int again = 2; !taken.insert(map.name).second; ++again) {
        map.name = fmt::format("{}-{}", name, again);
    }
    map.title = fmt::format("{}: {}, {}", analysis::view_name(row), setting, row.values);
}

/// Of a view whose camera was measured in other light before, only what the study shows and, unless
/// it is to be quick, how each technique is published: light changes neither accessibility nor its
/// time.
std::vector<Setting> only_shown(const MeasuredView& view, const stimuli::Study& study, bool quick,
                                const std::vector<Setting>& all) {
    std::vector<Setting> kept;
    for (const Setting& setting : all) {
        bool wanted = !setting.shown.empty();
        if (!quick) {
            for (const Valued& way : published_choices(view, study, setting.choice.technique)) {
                wanted |= way.choice.samples == setting.choice.samples &&
                          way.choice.denoise == setting.choice.denoise &&
                          renderer::same_options(way.choice, setting.choice);
            }
        }
        if (wanted) kept.push_back(setting);
    }
    return kept;
}

/// The settings of each view.
std::vector<std::vector<Setting>> settings_of_all(const MeasureRequest& request,
                                                  const stimuli::Study& study,
                                                  const std::vector<MeasuredView>& views,
                                                  const std::vector<FittedChoice>& fitted) {
    std::vector<std::vector<Setting>> settings;
    for (auto view = views.begin(); view != views.end(); ++view) {
        settings.push_back(all_settings(request, study, *view, fitted));
        const bool seen = std::any_of(views.begin(), view, [&](const MeasuredView& before) {
            return before.scene == view->scene && before.camera == view->camera;
        });
        if (seen) settings.back() = only_shown(*view, study, request.quick, settings.back());
    }
    return settings;
}

void sweep_all(MeasuredScene& stage, const MeasureRequest& request, const stimuli::Study& study,
               const std::vector<MeasuredView>& views, Measured& measured,
               const TimerCheck& timers) {
    std::vector<FittedChoice> fitted;
    const bool writes = !request.write_study.empty();
    // Once before the work, for what would be wrong with the text however the fits turn out.
    if (writes) (void)fitted_study(request, study, views, {});
    if (request.fit) fitted = fit_all(stage, request, study, views);
    if (writes) {
        FittedStudy written = fitted_study(request, study, views, fitted);
        measured.fitted_study = std::move(written.text);
        for (std::string& note : written.notes) measured.notes.push_back(std::move(note));
    }
    const std::vector<std::vector<Setting>> settings =
        settings_of_all(request, study, views, fitted);
    SweptViews swept = sweep_views(stage, request, "measure", views, settings, timers);
    measured.interrupted = swept.interrupted;
    for (std::string& note : swept.notes) measured.notes.push_back(std::move(note));
    analysis::MeasurementReport& report = measured.report;
    std::vector<std::pair<std::size_t, analysis::ErrorMap>> maps;
    for (SweptView& view : swept.views) {
        for (auto& [row, map] : view.maps) {
            maps.emplace_back(report.rows.size() + row, std::move(map));
        }
        for (auto& row : view.rows) report.rows.push_back(std::move(row));
    }
    analysis::name_variants_apart(report.rows);
    analysis::mark_front(report.rows);
    std::set<std::string> taken;
    for (auto& [row, map] : maps) {
        name_map(map, report.rows[row], taken);
        report.maps.push_back(std::move(map));
    }
    for (const FittedChoice& fit : fitted) report.fitted.push_back(fit.record);
}

}  // namespace

MeasureRequest with_defaults(MeasureRequest request) {
    const MeasureSize& usual = request.quick ? kQuickSize : kUsualSize;
    request.width = request.width.value_or(usual.width);
    request.height = request.height.value_or(usual.height);
    request.rays = request.rays.value_or(usual.rays);
    request.runs = request.runs.value_or(usual.runs);
    return request;
}

Measured measure(const MeasureRequest& asked, const std::vector<stimuli::BuiltinScene>& catalogue) {
    const MeasureRequest request = with_defaults(asked);
    check_request(request);
    const stimuli::Study study = stimuli::load_study(request.study);
    const std::vector<MeasuredView> views = by_scene(views_of(request, study, catalogue));
    const renderer::HeadlessContext context;
    Measured measured;
    measured.report.device = renderer::gpu_description();
    measured.report.denoise = kPlottedFilter;
    measured.report.of_study = request.scenes.empty();
    measured.report.asks_order = request.scenes.empty() && study.name == kThesis;
    measured.report.title = request.hard_cases ? "Hard cases"
                            : request.growth   ? "How cost grows"
                                               : "Speed against error";
    if (request.hard_cases) {
        measured.report.hard_cases = run_all_hard_cases(request);
        return measured;
    }
    if (views.empty()) throw base::bad_input("the study {} has no scene to measure", study.name);

    if (request.scenes.empty() && request.experiment.empty()) note_unmeasured(study, measured);
    note_steps(request, measured);
    if (request.experiment.empty()) {
        for (std::string& note : left_out_of(request)) measured.notes.push_back(std::move(note));
    }
    MeasuredScene stage(request);
    const TimerCheck timers = check_timers(stage, views.front(), heavy_choice(request));
    measured.report.timer_check = timers.sentence;
    measured.report.method = method_of(request, timers);
    if (request.growth) {
        base::Progress progress("growth", growth_steps(request), request.quiet);
        measured.report.growth =
            measure_growth(stage, request, views.front(), timers,
                           [&progress](const std::string& what) { progress.step(what); });
        return measured;
    }
    if (!request.experiment.empty()) {
        measured.report.of_study = measured.report.asks_order = false;
        for (std::string& note :
             run_experiment(stage, request, study, views, timers, measured.report)) {
            measured.notes.push_back(std::move(note));
        }
        return measured;
    }
    sweep_all(stage, request, study, views, measured, timers);
    return measured;
}

}  // namespace obscura::app
