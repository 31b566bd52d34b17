// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/sweep_views.h"

#include <fmt/format.h>

#include <memory>

#include "app/measure/kept_views.h"
#include "renderer/base/error.h"
#include "renderer/base/interrupt.h"
#include "renderer/base/progress.h"

namespace obscura::app {
namespace {

/// Ends the work on a view that is not finished.
struct Interrupted {};

/// What takes how long: to open a view with its truths, a setting's first image, to run it again.
enum Kind : std::size_t { kView, kImage, kRun };

std::size_t runs_of(const MeasureRequest& request, const std::vector<Setting>& settings) {
    return settings.size() * static_cast<std::size_t>(kDiscardedRuns + *request.runs - 1);
}

/// Tells `progress` of the sweeps, and ends them on Ctrl-C.
SweepWatcher watcher_of(base::Progress& progress, const base::StopOnInterrupt& stop) {
    const auto seconds = std::make_shared<double>(0.0);
    const auto images = std::make_shared<double>(0.0);
    return {[&progress, &stop, seconds, images](const std::string& what, double again_ms) {
                if (stop.asked()) throw Interrupted();
                *seconds += again_ms / 1000.0;
                progress.left().expect(kRun, *seconds / ++*images);
                progress.step(what, kImage);
            },
            [&progress, &stop](const std::string& what) {
                if (stop.asked()) throw Interrupted();
                progress.step(what, kRun);
            }};
}

}  // namespace

SweptViews sweep_views(MeasuredScene& stage, const MeasureRequest& request,
                       const std::string& title, const std::vector<MeasuredView>& views,
                       const std::vector<std::vector<Setting>>& settings,
                       const TimerCheck& timers) {
    std::size_t images = 0;
    std::size_t runs = 0;
    for (const std::vector<Setting>& of_view : settings) {
        images += of_view.size();
        runs += runs_of(request, of_view);
    }
    base::Progress progress(title, {views.size(), images, runs}, request.quiet);
    const base::StopOnInterrupt stop;
    const SweepWatcher watcher = watcher_of(progress, stop);
    KeptViews kept(request.kept_views);
    SweptViews swept;
    std::size_t of_before = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const std::string description =
            description_of(stage, request, views[i], settings[i], timers);
        progress.step(views[i].scene->id + ' ' + views[i].camera, kView);
        if (std::optional<SweptView> before = kept.find(description)) {
            swept.views.push_back(std::move(*before));
            progress.left().leave_out(kImage, settings[i].size());
            progress.left().leave_out(kRun, runs_of(request, settings[i]));
            ++of_before;
            continue;
        }
        try {
            swept.views.push_back(sweep(stage, request, views[i], settings[i], timers, watcher));
        } catch (const Interrupted&) {
            if (i == 0) throw base::failure("interrupted before the first view was finished");
            swept.interrupted = true;
            break;
        }
        kept.keep(description, swept.views.back());
    }
    if (of_before > 0) {
        swept.notes.push_back(fmt::format(
            "{} of {} views, with their times, are of a run before that was ended half-way",
            of_before, views.size()));
    }
    if (swept.interrupted) {
        swept.notes.push_back(fmt::format("interrupted: {} of {} views were finished",
                                          swept.views.size(), views.size()));
    } else {
        kept.give_up();
    }
    return swept;
}

}  // namespace obscura::app
