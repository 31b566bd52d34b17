// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace obscura::app::explorer {
namespace {

void add(std::vector<Preset>& presets, Preset preset) {
    if (!renderer::problems_of(preset.variant).empty()) return;
    const bool there = std::any_of(presets.begin(), presets.end(),
                                   [&](const Preset& held) { return held.name == preset.name; });
    if (!there) presets.push_back(std::move(preset));
}

/// What papers compare by numbers of samples, with the technique's published values.
struct PaperSamples {
    const char* technique;
    const char* paper;
    int samples;
};
constexpr std::array kPapers{
    PaperSamples{"hemisphere", "Whinham 2017", 4},  PaperSamples{"hemisphere", "Whinham 2017", 8},
    PaperSamples{"hemisphere", "Whinham 2017", 16}, PaperSamples{"hemisphere", "Whinham 2017", 32},
    PaperSamples{"hemisphere", "Whinham 2017", 64}, PaperSamples{"hemisphere", "Whinham 2017", 128},
};

void add_papers(std::vector<Preset>& presets, const renderer::Technique& technique,
                const renderer::Variant& now) {
    for (const PaperSamples& paper : kPapers) {
        if (technique.name != paper.technique) continue;
        renderer::Variant variant = switched_to(technique, now);
        variant.samples = paper.samples;
        add(presets,
            {fmt::format("{}, {} samples", paper.paper, paper.samples),
             fmt::format("One of the numbers of samples that {} compares", paper.paper), variant});
    }
}

}  // namespace

std::vector<Preset> presets_of(const renderer::Variant& now,
                               const std::optional<OpenStudy>& study) {
    const std::string& technique = now.technique;
    std::vector<Preset> presets;
    const renderer::Technique* descriptor = renderer::find_technique(technique);
    if (descriptor == nullptr) return presets;
    for (const std::string& name : renderer::preset_names()) {
        renderer::Variant variant = switched_to(*descriptor, now);
        // Of several sets of values that reach as far: the radius is the scene's.
        const bool fitted = name != renderer::preset_names().front();
        if (!renderer::apply_preset(name, variant).empty()) continue;
        add(presets, {name,
                      fitted ? "The values that come nearest to the truth, one set for all scenes"
                             : "The source's own values: " + descriptor->citation,
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
