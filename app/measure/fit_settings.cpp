// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/fit_settings.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/measure/sweep.h"
#include "renderer/base/error.h"

namespace obscura::app {
namespace {

using renderer::Parameter;
using renderer::Variant;

constexpr double kReach = 20.0;  ///< factor of the published value that is searched, down and up

/// The views of a scene that a fit trains on and those that it is reported on.
struct Cameras {
    std::vector<std::string> training;
    std::vector<std::string> reported;
};

Cameras cameras_of(const std::vector<MeasuredView>& views, const MeasuredView& view) {
    Cameras cameras;
    const auto add = [](std::vector<std::string>& list, const std::string& name) {
        if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
    };
    for (const MeasuredView& other : views) {
        if (other.scene == view.scene) add(cameras.reported, other.camera);
    }
    for (const std::string& name : view.scene->cameras) {
        const bool reported = std::find(cameras.reported.begin(), cameras.reported.end(), name) !=
                              cameras.reported.end();
        if (!reported) cameras.training.push_back(name);
    }
    if (!cameras.training.empty()) return cameras;
    // Every camera is measured: the first is for training, the others for the report.
    if (cameras.reported.size() > 1) {
        cameras.training = {cameras.reported.front()};
        cameras.reported.erase(cameras.reported.begin());
    } else {
        cameras.training = cameras.reported;
    }
    return cameras;
}

/// What was not moved is what it was, not what the way through a logarithm makes of it.
double value_of(const analysis::Unknown& unknown, double found) {
    const bool moved = std::abs(found - unknown.start) > 1e-12 * std::abs(unknown.start);
    return moved ? found : unknown.start;
}

/// What the study calls the views of that scene.
std::string ids_of(const std::vector<MeasuredView>& views, const MeasuredView& view) {
    std::vector<std::string> ids;
    for (const MeasuredView& other : views) {
        const bool known = std::find(ids.begin(), ids.end(), other.scene_id) != ids.end();
        if (other.scene == view.scene && !known) ids.push_back(other.scene_id);
    }
    return fmt::format("{}", fmt::join(ids, ", "));
}

/// The root mean square of the RMSE on each training camera.
double training_rmse(MeasuredScene& stage, const FitEffort& effort, const MeasuredView& view,
                     const std::vector<std::string>& cameras, const Variant& choice,
                     double radius_m) {
    double sum = 0.0;
    for (const std::string& camera : cameras) {
        MeasuredView at = view;
        at.camera = camera;
        const renderer::ReferenceImage& truth =
            stage.truth(at, radius_m, effort.width, effort.height, effort.rays);
        const renderer::Frame frame = stage.render_plainly(at, choice, effort.width, effort.height);
        const auto error = analysis::accessibility_error(
            frame.read_accessibility(), truth.accessibility, surface_mask(frame, truth));
        if (!error.has_value()) {
            throw base::bad_input("scene \"{}\", camera \"{}\": {}", view.scene->id, camera,
                                  error.reason);
        }
        sum += error->rmse * error->rmse;
    }
    return std::sqrt(sum / static_cast<double>(cameras.size()));
}

}  // namespace

bool FittedChoice::is_for(const stimuli::SceneSource& on, const Variant& other) const {
    if (scene.get() != &on || other.technique != published.technique) return false;
    const auto& parameters = renderer::find_technique(other.technique)->parameters;
    return std::all_of(parameters.begin(), parameters.end(), [&](const Parameter& parameter) {
        const bool found_by_fit =
            parameter.fit && !parameter.whole && parameter.name != kTruthRadius;
        return found_by_fit || other.value_of(parameter) == published.value_of(parameter);
    });
}

FitEffort fit_effort(const MeasureRequest& request) {
    FitEffort effort;
    effort.width = std::min(effort.width, *request.width);
    effort.height = std::min(effort.height, *request.height);
    effort.rays = std::min(effort.rays, *request.rays);
    if (request.quick)
        effort.search = {
            .starts = 1, .scouts = 15, .evaluations = 25, .tolerance = 1e-2, .seed = 1};
    return effort;
}

std::vector<analysis::Unknown> unknowns_of(const Variant& choice) {
    std::vector<analysis::Unknown> unknowns;
    for (const Parameter& parameter : renderer::find_technique(choice.technique)->parameters) {
        if (!parameter.fit || parameter.whole) continue;
        const double value = choice.value_of(parameter);
        analysis::Unknown unknown;
        unknown.name = parameter.name;
        unknown.logarithmic = value > 0.0;
        unknown.low = value > 0.0 ? std::max(parameter.low, value / kReach) : parameter.low;
        unknown.high = value > 0.0 ? std::min(parameter.high, value * kReach)
                                   : std::min(parameter.high, parameter.low + 1.0);
        unknown.start = value;
        if (unknown.high > unknown.low) unknowns.push_back(unknown);
    }
    return unknowns;
}

FittedChoice fit_on_scene(MeasuredScene& stage, const FitEffort& effort,
                          const std::vector<MeasuredView>& views, const MeasuredView& view,
                          const Variant& published,
                          const std::function<void(const std::string&)>& step) {
    const Cameras cameras = cameras_of(views, view);
    const double radius_m = truth_radius_m(view, published);
    const std::vector<analysis::Unknown> unknowns = unknowns_of(published);
    const auto with = [&](std::span<const double> values) {
        Variant choice = published;
        for (std::size_t i = 0; i < values.size(); ++i) {
            choice.parameters[unknowns[i].name] = value_of(unknowns[i], values[i]);
        }
        return choice;
    };
    const auto error_of = [&](std::span<const double> values) {
        const double error =
            training_rmse(stage, effort, view, cameras.training, with(values), radius_m);
        step(view.scene->id + ' ' + published.variant_name());
        return error;
    };
    const analysis::Minimum found = analysis::minimise(unknowns, error_of, effort.search);

    FittedChoice fitted;
    fitted.scene = view.scene;
    fitted.published = published;
    fitted.choice = with(found.values);
    analysis::Fitted& record = fitted.record;
    record.scene_id = ids_of(views, view);
    record.scene = view.scene->id;
    record.depth_format = published.depth_format;
    record.technique = published.technique;
    record.samples = published.samples;
    record.denoise = published.denoise;
    record.training_cameras = cameras.training;
    record.reported_cameras = cameras.reported;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        record.before[unknowns[i].name] = unknowns[i].start;
        record.after[unknowns[i].name] = value_of(unknowns[i], found.values[i]);
    }
    record.training_rmse_before = found.at_start;
    record.training_rmse_after = found.smallest;
    record.evaluations = found.evaluations;
    return fitted;
}

}  // namespace obscura::app
