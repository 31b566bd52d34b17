// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/choices.h"

#include <algorithm>
#include <cmath>

#include "renderer/denoise/denoise.h"

namespace obscura::app::explorer {
namespace {

constexpr const char* kRadius = "radius_m";

[[nodiscard]] std::optional<double> radius_of(const renderer::Variant& variant) {
    const renderer::Technique* technique = renderer::find_technique(variant.technique);
    const renderer::Parameter* radius =
        technique != nullptr ? technique->find_parameter(kRadius) : nullptr;
    if (radius == nullptr) return std::nullopt;
    return variant.value_of(*radius);
}

}  // namespace

bool Choices::operator==(const Choices& other) const {
    return same_source(*this, other) && scene.id == other.scene.id &&
           scene.camera == other.scene.camera && scene.validity == other.scene.validity &&
           stimuli::to_json(scene.settings) == stimuli::to_json(other.scene.settings) &&
           width == other.width && height == other.height && supersampling == other.supersampling &&
           occluding_opacity == other.occluding_opacity && a == other.a && b == other.b &&
           truth_radius_m == other.truth_radius_m;
}

bool same_source(const Choices& a, const Choices& b) {
    return a.scene.source == b.scene.source && a.scene.settings.scale == b.scene.settings.scale &&
           a.folder == b.folder;
}

double standard_truth_radius_m(const Choices& choices) {
    if (const auto radius = radius_of(choices.b)) return *radius;
    if (const auto radius = radius_of(choices.a)) return *radius;
    for (const renderer::Technique& technique : renderer::techniques()) {
        if (const renderer::Parameter* radius = technique.find_parameter(kRadius)) {
            return radius->standard;
        }
    }
    return 0.5;
}

double truth_radius_m(const Choices& choices) {
    return choices.truth_radius_m.value_or(standard_truth_radius_m(choices));
}

renderer::Variant switched_to(const renderer::Technique& technique,
                              const renderer::Variant& before) {
    renderer::Variant variant = renderer::standard_variant(technique);
    variant.denoise = renderer::standard_denoise(technique);
    const renderer::Parameter* radius = technique.find_parameter(kRadius);
    const auto held = radius_of(before);
    if (radius != nullptr && held) {
        if (const auto value = allowed_value(*radius, *held)) variant.parameters[kRadius] = *value;
    }
    return variant;
}

int allowed_samples(const renderer::Technique& technique, int wanted) {
    const renderer::SampleRange& range = technique.samples;
    const int step = std::max(1, range.multiple_of);
    const int held = std::clamp(wanted, range.low, range.high);
    // The nearest multiple that lies in the range.
    int nearest = held / step * step;
    if (held - nearest > step / 2) nearest += step;
    while (nearest < range.low) nearest += step;
    while (nearest > range.high) nearest -= step;
    return nearest;
}

std::optional<double> allowed_value(const renderer::Parameter& parameter, double wanted) {
    if (std::isnan(wanted)) return std::nullopt;
    const double held = std::clamp(wanted, parameter.low, parameter.high);
    return parameter.whole ? std::clamp(std::round(held), parameter.low, parameter.high) : held;
}

}  // namespace obscura::app::explorer
