// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
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
    renderer::Variant choice;
};

/// One view of one scene that is measured.
struct MeasuredView {
    std::string scene_id;  ///< the study's; without a study the scene's own
    std::shared_ptr<const stimuli::SceneSource> scene;  ///< views of one scene share it
    std::string camera;
    stimuli::Validity validity = stimuli::Validity::kLow;
    double radius_m = 0.5;  ///< R of the truth for techniques that have no radius of their own
    renderer::FrameOptions options;  ///< as the study shows it
    std::vector<ShownSetting> shown;
};

/// The views that the request asks for: those of the study, or every camera of its scenes. Throws
/// bad input naming the option for an unknown scene.
[[nodiscard]] std::vector<MeasuredView> views_of(
    const MeasureRequest& request, const stimuli::Study& study,
    const std::vector<stimuli::BuiltinScene>& catalogue);

/// The first view of each scene.
[[nodiscard]] std::vector<MeasuredView> one_a_scene(const std::vector<MeasuredView>& views);

/// What the study shows on the scenes that are wanted.
[[nodiscard]] std::vector<ShownSetting> settings_shown(
    const stimuli::Study& study, const std::function<bool(const stimuli::StudyScene&)>& wanted);

/// On scenes of that source.
[[nodiscard]] std::vector<ShownSetting> shown_on(const stimuli::Study& study,
                                                 const std::string& source);

}  // namespace obscura::app
