// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/fit/minimise.h"
#include "analysis/measurement/report.h"
#include "app/measure/measured_scene.h"

namespace obscura::app {

/// A technique with values that were fitted on one scene.
struct FittedChoice {
    std::shared_ptr<const stimuli::SceneSource> scene;
    renderer::Variant published;  ///< what it was made of: samples and filter of the fit
    renderer::Variant choice;     ///< the same with fitted values

    /// Whether the values are for that choice on that scene too: the technique, R of the truth and
    /// every parameter that a fit leaves alone are the same. Where a fit starts, samples, filter
    /// and formats may be others.
    [[nodiscard]] bool is_for(const stimuli::SceneSource& on, const renderer::Variant& other) const;
    analysis::Fitted record;
};

/// The size and effort of a fit.
struct FitEffort {
    int width = 160;
    int height = 90;
    int rays = 128;
    analysis::MinimiseOptions search{.starts = 3, .evaluations = 50, .tolerance = 1e-3, .seed = 1};
};
[[nodiscard]] FitEffort fit_effort(const MeasureRequest& request);

/// What a fit may vary of a choice: every parameter that its descriptor lets it, a factor of 20
/// down and up from the published value, within the descriptor's range.
[[nodiscard]] std::vector<analysis::Unknown> unknowns_of(const renderer::Variant& choice);

/// Fits `published` on the scene's cameras that are in no view of `views` (on those of the views
/// where there is no other) to the truth within the published radius: the smallest root mean square
/// of the cameras' RMSE. `step` is called after each trial of values.
[[nodiscard]] FittedChoice fit_on_scene(MeasuredScene& stage, const FitEffort& effort,
                                        const std::vector<MeasuredView>& views,
                                        const MeasuredView& view,
                                        const renderer::Variant& published,
                                        const std::function<void(const std::string&)>& step);

}  // namespace obscura::app
