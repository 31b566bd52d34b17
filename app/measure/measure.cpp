// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/measure.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "app/measure/fit_settings.h"
#include "app/measure/growth.h"
#include "app/measure/hard_cases.h"
#include "app/measure/sweep.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/gl/context.h"
#include "stimuli/study_writer.h"

namespace obscura::app {
namespace {

using renderer::TechniqueChoice;

/// The views in an order that has those of one scene together.
std::vector<View> by_scene(std::vector<View> views) {
    std::stable_sort(views.begin(), views.end(), [](const View& a, const View& b) {
        return a.scene->source < b.scene->source;
    });
    return views;
}

bool can_be_fitted(const std::string& technique) {
    const renderer::Technique& descriptor = *renderer::find_technique(technique);
    return descriptor.samples.high > 0 && !descriptor.parameters.empty();
}

/// Each technique on each scene, as the study shows it there.
std::vector<FittedChoice> fit_all(Stage& stage, const MeasureRequest& request,
                                  const stimuli::Study& study, const std::vector<View>& views) {
    const FitEffort effort = fit_effort(request);
    std::vector<std::pair<const View*, TechniqueChoice>> wanted;
    const stimuli::SceneSource* last = nullptr;
    for (const View& view : views) {
        if (view.scene.get() == last) continue;
        last = view.scene.get();
        for (const std::string& name : measured_techniques(request)) {
            if (!can_be_fitted(name)) continue;
            wanted.emplace_back(&view, published_choice(view, study, name));
        }
    }
    const auto trials = static_cast<std::size_t>(effort.search.starts * effort.search.evaluations);
    base::Progress progress("fit (at most)", wanted.size() * (trials + 1), request.quiet);
    std::vector<FittedChoice> fitted;
    for (const auto& [view, choice] : wanted) {
        fitted.push_back(
            fit_on_scene(stage, effort, views, *view, choice,
                         [&progress](const std::string& what) { progress.step(what); }));
    }
    return fitted;
}

/// What is measured on a view: everything as published, and with fitted values the settings with
/// the filter of the plots and those that the study shows.
std::vector<Setting> all_settings(const MeasureRequest& request, const stimuli::Study& study,
                                  const View& view, const std::vector<FittedChoice>& fitted) {
    std::vector<Setting> settings;
    for (const TechniqueChoice& choice : settings_of(request, view, study)) {
        const double radius_m =
            truth_radius_m(view, published_choice(view, study, choice.technique));
        settings.push_back({choice, radius_m, false});
    }
    const std::size_t published = settings.size();
    for (const FittedChoice& fit : fitted) {
        if (fit.source != view.scene->source) continue;
        for (std::size_t i = 0; i < published; ++i) {
            const TechniqueChoice& choice = settings[i].choice;
            if (choice.technique != fit.choice.technique || choice.denoise != fit.choice.denoise ||
                choice.depth_format != "r32f") {
                continue;
            }
            Setting setting{choice, settings[i].truth_radius_m, true};
            setting.choice.parameters = fit.choice.parameters;
            settings.push_back(setting);
        }
    }
    return settings;
}

std::vector<std::string> method_of(const MeasureRequest& request, const TimerCheck& timers) {
    return {
        fmt::format("Images of {}x{} pixels; the truth is traced with {} rays a pixel from the "
                    "geometric normal, within the radius that the study gives the technique (for a "
                    "technique without one, the radius that the others have on that scene).",
                    request.width, request.height, request.rays),
        fmt::format(
            "The accessibility pass and the filter of each setting are run {} times, in turn "
            "with all other settings of the view; the first {} are thrown away. The other "
            "passes of a frame are timed {} times for each plan, and frame times are the "
            "sum. Times are of {}.",
            kDiscardedRuns + request.runs, kDiscardedRuns, request.runs,
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
        "Fitted values are the descriptor's continuous parameters, found by NLopt on cameras that "
        "are not reported on where the scene has such; the number of samples is never fitted."};
}

/// The study's text with the fitted values of each side's technique on its scene.
std::string study_with(const std::string& name, const stimuli::Study& study,
                       const std::vector<FittedChoice>& fitted) {
    std::vector<stimuli::VariantChange> changes;
    for (const stimuli::Condition& condition : study.conditions) {
        const std::string& source = study.scene_of(condition).source;
        for (const char side : {'a', 'b'}) {
            const TechniqueChoice& shown = side == 'a' ? condition.a : condition.b;
            for (const FittedChoice& fit : fitted) {
                if (fit.source != source || fit.choice.technique != shown.technique) continue;
                TechniqueChoice changed = shown;
                for (const auto& [key, value] : fit.record.after) changed.parameters[key] = value;
                changes.push_back({condition.id, side, changed});
            }
        }
    }
    return stimuli::with_variants(stimuli::study_source(name).text, name, changes);
}

/// The setting that the timers are checked with: the most expensive technique's.
TechniqueChoice heavy_choice(const MeasureRequest& request) {
    TechniqueChoice choice;
    int most = -1;
    for (const std::string& name : measured_techniques(request)) {
        const renderer::Technique& technique = *renderer::find_technique(name);
        TechniqueChoice candidate;
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

/// One map for each picture: the views of several levels of light have the same accessibility.
void add_maps(std::vector<analysis::ErrorMap>& maps, std::vector<analysis::ErrorMap> more) {
    for (analysis::ErrorMap& map : more) {
        const bool there = std::any_of(maps.begin(), maps.end(),
                                       [&](const auto& held) { return held.name == map.name; });
        if (!there) maps.push_back(std::move(map));
    }
}

/// Of a view whose camera was measured in other light before, only what the study shows and, unless
/// it is to be quick, how each technique is published: light changes neither accessibility nor its
/// time.
std::vector<Setting> only_shown(const View& view, const stimuli::Study& study, bool quick,
                                const std::vector<Setting>& all) {
    std::vector<Setting> shown;
    for (const Setting& setting : all) {
        const TechniqueChoice published = published_choice(view, study, setting.choice.technique);
        const auto same = [&](const TechniqueChoice& choice) {
            return choice.technique == setting.choice.technique &&
                   choice.samples == setting.choice.samples &&
                   choice.denoise == setting.choice.denoise;
        };
        bool wanted = !quick && same(published);
        for (const ShownSetting& by_study : view.shown) wanted |= same(by_study.choice);
        if (wanted && setting.choice.depth_format == "r32f") shown.push_back(setting);
    }
    return shown;
}

void sweep_all(Stage& stage, const MeasureRequest& request, const stimuli::Study& study,
               const std::vector<View>& views, Measured& measured, const TimerCheck& timers) {
    std::vector<FittedChoice> fitted;
    if (request.fit) fitted = fit_all(stage, request, study, views);
    std::vector<std::vector<Setting>> settings;
    std::size_t count = 0;
    for (auto view = views.begin(); view != views.end(); ++view) {
        settings.push_back(all_settings(request, study, *view, fitted));
        const bool seen = std::any_of(views.begin(), view, [&](const View& before) {
            return before.scene == view->scene && before.camera == view->camera;
        });
        if (seen) settings.back() = only_shown(*view, study, request.quick, settings.back());
        count += settings.back().size();
    }
    base::Progress progress(
        "measure", count * static_cast<std::size_t>(kDiscardedRuns + request.runs), request.quiet);
    for (std::size_t i = 0; i < views.size(); ++i) {
        SweptView swept = sweep(stage, request, views[i], settings[i], timers,
                                [&progress](const std::string& what) { progress.step(what); });
        for (auto& row : swept.rows) measured.report.rows.push_back(std::move(row));
        add_maps(measured.report.maps, std::move(swept.maps));
    }
    analysis::mark_front(measured.report.rows);
    for (const FittedChoice& fit : fitted) measured.report.fitted.push_back(fit.record);
    if (!request.write_study.empty()) {
        measured.fitted_study = study_with(request.study, study, fitted);
    }
}

}  // namespace

MeasureRequest with_defaults(MeasureRequest request) {
    if (!request.quick) return request;
    const MeasureRequest usual;
    if (request.width == usual.width && request.height == usual.height) {
        request.width = 256;
        request.height = 144;
    }
    if (request.rays == usual.rays) request.rays = 64;
    if (request.runs == usual.runs) request.runs = 3;
    return request;
}

Measured measure(const MeasureRequest& asked, const std::vector<stimuli::BuiltinScene>& catalogue) {
    const MeasureRequest request = with_defaults(asked);
    check_request(request);
    const stimuli::Study study = stimuli::load_study(request.study);
    const std::vector<View> views = by_scene(views_of(request, study, catalogue));
    const renderer::HeadlessContext context;
    Measured measured;
    measured.report.device = renderer::gpu_description();
    measured.report.blur = kPlottedFilter;
    measured.report.title = request.hard_cases ? "Hard cases"
                            : request.growth   ? "How cost grows"
                                               : "Speed against error";
    if (request.hard_cases) measured.report.hard_cases = run_all_hard_cases(request);
    if (request.hard_cases && !request.growth) return measured;
    if (views.empty()) throw base::bad_input("the study {} has no scene to measure", study.name);

    Stage stage(request);
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
    sweep_all(stage, request, study, views, measured, timers);
    return measured;
}

}  // namespace obscura::app
