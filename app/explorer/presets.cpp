// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/presets.h"

#include <fmt/format.h>

#include <algorithm>

#include "stimuli/paper_configurations.h"

namespace obscura::app::explorer {
namespace {

void add(std::vector<Preset>& presets, Preset preset) {
    if (!renderer::problems_of(preset.variant).empty()) return;
    const bool there = std::any_of(presets.begin(), presets.end(),
                                   [&](const Preset& held) { return held.name == preset.name; });
    if (!there) presets.push_back(std::move(preset));
}

/// The radius stays the scene's.
void add_papers(std::vector<Preset>& presets, const renderer::Technique& technique,
                const renderer::Variant& now) {
    for (const stimuli::PaperConfiguration& paper : stimuli::paper_configurations()) {
        if (paper.variant.technique != technique.name) continue;
        renderer::Variant variant = switched_to(technique, now);
        variant.samples = paper.variant.samples;
        variant.denoise = paper.variant.denoise;
        for (const auto& [name, value] : paper.variant.parameters) variant.parameters[name] = value;
        add(presets, {paper.name, paper.meaning, variant});
    }
}

}  // namespace

std::vector<Preset> presets_of(const renderer::Variant& now, const std::optional<OpenStudy>& study,
                               const std::vector<FittedValues>& fitted, const std::string& scene) {
    const std::string& technique = now.technique;
    std::vector<Preset> presets;
    const renderer::Technique* descriptor = renderer::find_technique(technique);
    if (descriptor == nullptr) return presets;
    for (const std::string& name : renderer::preset_names()) {
        renderer::Variant variant = switched_to(*descriptor, now);
        // Of several sets of values that reach as far: the radius is the scene's.
        const bool nearest = name != renderer::preset_names().front();
        if (!renderer::apply_preset(name, variant).empty()) continue;
        add(presets, {name,
                      nearest ? "The values that come nearest to the truth, one set for all scenes"
                              : "The source's own values: " + descriptor->citation,
                      variant});
    }
    for (const FittedValues& values : fitted) {
        if (values.scene != scene || values.technique != technique) continue;
        renderer::Variant variant = now;
        for (const auto& [name, value] : values.parameters) variant.parameters[name] = value;
        add(presets, {fmt::format("fitted on {}", scene),
                      fmt::format("What obscura measure --fit found for this scene: RMSE {} on the "
                                  "cameras that it was found on",
                                  values.rmse),
                      variant});
    }
    add_papers(presets, *descriptor, now);
    if (!study) return presets;
    for (const stimuli::Condition& condition : study->study.conditions) {
        for (const char side : {'a', 'b'}) {
            const renderer::Variant& shown = side == 'a' ? condition.a : condition.b;
            if (shown.technique != technique) continue;
            add(presets,
                {fmt::format("condition {} {}", condition.id, side),
                 fmt::format("As {} shows it: {}", study->study.name, shown.in_words()), shown});
        }
    }
    return presets;
}

}  // namespace obscura::app::explorer
