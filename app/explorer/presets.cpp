// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/presets.h"

#include <fmt/format.h>

#include <algorithm>

namespace obscura::app::explorer {
namespace {

void add(std::vector<Preset>& presets, Preset preset) {
    if (!renderer::problems_of(preset.variant).empty()) return;
    const bool there = std::any_of(presets.begin(), presets.end(),
                                   [&](const Preset& held) { return held.name == preset.name; });
    if (!there) presets.push_back(std::move(preset));
}

}  // namespace

std::vector<Preset> presets_of(const std::string& technique,
                               const std::optional<OpenStudy>& study) {
    std::vector<Preset> presets;
    const renderer::Technique* descriptor = renderer::find_technique(technique);
    if (descriptor == nullptr) return presets;
    renderer::Variant standard = renderer::standard_variant(*descriptor);
    standard.denoise = renderer::standard_denoise(*descriptor);
    add(presets, {"standard", "The descriptor's defaults: " + descriptor->citation, standard});
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
