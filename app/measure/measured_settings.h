// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/measure/measured_view.h"
#include "app/measure/request.h"
#include "renderer/technique/technique.h"
#include "stimuli/study.h"

namespace obscura::app {

/// Where a setting's values come from.
enum class Values {
    kPublished,  ///< the study's, for that scene
    kStandard,   ///< the descriptor's
    kStart,      ///< another scene of the study: where a fit would start
    kAsked,      ///< some of them the request's own
    kFitted
};
[[nodiscard]] std::string to_string(Values values);

/// A technique with the values that it is measured with.
struct Valued {
    renderer::Variant choice;
    Values values = Values::kPublished;
};

/// A technique in every way in which the study shows it on this view, one for each set of
/// parameters; else in the first way on this scene; else one with the values that the study gives
/// to parameters of the same name on this scene, or as it shows the technique elsewhere, or as the
/// descriptor says. Samples are the shown ones, or the descriptor's. Never empty.
[[nodiscard]] std::vector<Valued> published_choices(const MeasuredView& view,
                                                    const stimuli::Study& study,
                                                    const std::string& technique);

/// The parameter that is R of the truth where a technique has it.
inline constexpr const char* kTruthRadius = "radius_m";

/// R of the truth that a choice is held against before any fit: its own radius, or the view's.
[[nodiscard]] double truth_radius_m(const MeasuredView& view, const renderer::Variant& choice);

/// A setting with the study's values for the view's scene where it has none of its own.
[[nodiscard]] renderer::Variant on_view(renderer::Variant variant, const MeasuredView& view,
                                        const stimuli::Study& study);

/// Every setting to measure on a view, before any fit: each technique with each number of samples
/// and filter, and what the study shows; each once. `none` has one setting.
[[nodiscard]] std::vector<Valued> settings_of(const MeasureRequest& request,
                                              const MeasuredView& view,
                                              const stimuli::Study& study);

/// Whether the variant's technique has a parameter, or an option, of that name.
[[nodiscard]] bool has_setting(const renderer::Variant& variant, const std::string& key);

/// A sentence for each technique and number of samples that are left out though nobody asked for
/// others.
[[nodiscard]] std::vector<std::string> left_out_of(const MeasureRequest& request);

/// The techniques that are measured: the request's, or all that are not the truth themselves.
[[nodiscard]] std::vector<std::string> measured_techniques(const MeasureRequest& request);

/// Why a technique has no error to measure; empty where it has.
[[nodiscard]] std::string why_unmeasured(const renderer::Technique& technique);

}  // namespace obscura::app
