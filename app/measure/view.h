// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/measure/request.h"
#include "renderer/frame/plan.h"
#include "renderer/technique/technique.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/scenes/scene_source.h"
#include "stimuli/study.h"

namespace obscura::app {

/// A setting that the study shows on a view.
struct ShownSetting {
    std::string where;  ///< condition and side: `III a`
    renderer::TechniqueChoice choice;
};

/// One view of one scene that is measured.
struct View {
    std::shared_ptr<const stimuli::SceneSource> scene;  ///< views of one scene share it
    std::string camera;
    stimuli::Validity validity = stimuli::Validity::kLow;
    double radius_m = 0.5;  ///< R of the truth for techniques that have no radius of their own
    renderer::FrameOptions options;  ///< as the study shows it
    std::vector<ShownSetting> shown;
};

/// The views that the request asks for: those of the study, or every camera of its scenes. Throws
/// bad input naming the option for an unknown scene.
[[nodiscard]] std::vector<View> views_of(const MeasureRequest& request, const stimuli::Study& study,
                                         const std::vector<stimuli::BuiltinScene>& catalogue);

/// A technique as published for this view: as the study shows it here; else with the values that
/// the study gives to parameters of the same name on this scene; else as it shows the technique
/// elsewhere; else as the descriptor says. Samples are the shown ones, or the descriptor's.
[[nodiscard]] renderer::TechniqueChoice published_choice(const View& view,
                                                         const stimuli::Study& study,
                                                         const std::string& technique);

/// R of the truth that a choice is held against: its own radius, or the view's.
[[nodiscard]] double truth_radius_m(const View& view, const renderer::TechniqueChoice& published);

/// Every setting to measure on a view, as published: each technique with each number of samples
/// and filter, and what the study shows; each once. `none` has one setting.
[[nodiscard]] std::vector<renderer::TechniqueChoice> settings_of(const MeasureRequest& request,
                                                                 const View& view,
                                                                 const stimuli::Study& study);

/// The techniques that are measured: the request's, or all that are not the truth themselves.
[[nodiscard]] std::vector<std::string> measured_techniques(const MeasureRequest& request);

/// Throws bad input naming the option, the value and what is allowed for anything that is wrong
/// with techniques, samples, filters, sizes, rays or runs.
void check_request(const MeasureRequest& request);

}  // namespace obscura::app
