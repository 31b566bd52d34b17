// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/sane_choices.h"

#include <algorithm>
#include <cmath>

namespace obscura::app::explorer {
namespace {

/// As study files allow them.
constexpr float kLeastFactor = 1e-6F;
constexpr float kMostFactor = 1e6F;

void hold(std::optional<float>& factor) {
    if (!factor) return;
    if (std::isnan(*factor)) {
        factor.reset();
    } else {
        factor = std::clamp(*factor, kLeastFactor, kMostFactor);
    }
}

[[nodiscard]] renderer::Variant sane_variant(renderer::Variant variant,
                                             const renderer::Variant& before) {
    const renderer::Technique* technique = renderer::find_technique(variant.technique);
    if (technique == nullptr) return before;
    variant.samples = allowed_samples(*technique, variant.samples);
    if (!technique->makes_accessibility()) variant.denoise = "none";
    for (auto at = variant.parameters.begin(); at != variant.parameters.end();) {
        const renderer::Parameter* parameter = technique->find_parameter(at->first);
        const auto value =
            parameter != nullptr ? allowed_value(*parameter, at->second) : std::nullopt;
        if (value) {
            (at++)->second = *value;
        } else {
            at = variant.parameters.erase(at);
        }
    }
    return renderer::problems_of(variant).empty() ? variant : before;
}

}  // namespace

Choices sane(Choices choices, const Choices& before) {
    choices.supersampling = std::clamp(choices.supersampling, 1, renderer::kMostSupersampling);
    const int most = kMostImageSide / choices.supersampling;
    choices.width = std::clamp(choices.width, 1, most);
    choices.height = std::clamp(choices.height, 1, most);
    choices.a = sane_variant(std::move(choices.a), before.a);
    choices.b = sane_variant(std::move(choices.b), before.b);
    hold(choices.scene.settings.exposure);
    hold(choices.scene.settings.white);
    if (choices.truth_radius_m && std::isnan(*choices.truth_radius_m)) {
        choices.truth_radius_m.reset();
    }
    if (choices.truth_radius_m) {
        choices.truth_radius_m = std::clamp(*choices.truth_radius_m, 1e-6, 1e6);
    }
    if (choices.occluding_opacity &&
        !(*choices.occluding_opacity >= 0.01F && *choices.occluding_opacity <= 1.0F)) {
        choices.occluding_opacity = before.occluding_opacity;
    }
    choices.scene.settings.camera.reset();
    choices.scene.camera.clear();
    return choices;
}

Choices with_light_there_is(Choices choices, const stimuli::OpenedScene& opened) {
    const auto levels = stimuli::levels_with(opened.levels, choices.scene.settings);
    const bool there =
        std::find(levels.begin(), levels.end(), choices.scene.validity) != levels.end();
    if (!there && !levels.empty()) choices.scene.validity = levels.front();
    return choices;
}

}  // namespace obscura::app::explorer
