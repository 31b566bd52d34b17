// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/explorer/fields.h"
#include "app/explorer/presets.h"
#include "renderer/denoise/denoise.h"

namespace obscura::app::explorer {
namespace {

using renderer::Technique;
using renderer::Variant;

void edit(Desk& desk, char side, const std::string& name,
          const std::function<void(Variant&)>& change) {
    desk.model.change([&](Choices& choices) { change(choices.side(side)); },
                      name.empty() ? name : fmt::format("{} {}", side, name), desk.now_s);
}

void technique_menu(Desk& desk, char side, const Variant& variant) {
    std::vector<std::string> names;
    std::vector<std::string> citations;
    for (const Technique& technique : renderer::techniques()) {
        names.push_back(technique.name);
        citations.push_back(technique.citation);
    }
    const auto chosen =
        choice_field(desk, "technique", renderer::find_technique(variant.technique)->citation,
                     names, variant.technique, citations);
    if (!chosen) return;
    edit(desk, side, "",
         [&](Variant& to) { to = switched_to(*renderer::find_technique(*chosen), to); });
}

void preset_menu(Desk& desk, char side, const Variant& variant) {
    const std::vector<Preset> presets =
        presets_of(variant, desk.model.study(), desk.state.fitted,
                   desk.model.scene() ? desk.model.scene()->opened().id : std::string());
    std::vector<std::string> names;
    std::vector<std::string> meanings;
    std::string now = "own values";
    for (const Preset& preset : presets) {
        names.push_back(preset.name);
        meanings.push_back(preset.meaning);
        if (preset.variant == variant) now = preset.name;
    }
    const auto chosen =
        choice_field(desk, "preset", "Settings that have a name", names, now, meanings);
    if (!chosen) return;
    const auto found = std::find_if(presets.begin(), presets.end(),
                                    [&](const Preset& preset) { return preset.name == *chosen; });
    edit(desk, side, "", [&](Variant& to) { to = found->variant; });
}

void samples_field(Desk& desk, char side, const Technique& technique, const Variant& variant) {
    if (technique.samples.high == 0) return;
    NumberField field;
    field.name = "samples";
    field.tooltip =
        fmt::format("{} a pixel, in multiples of {}.", technique.ray_traced ? "Rays" : "Samples",
                    technique.samples.multiple_of);
    field.low = technique.samples.low;
    field.high = technique.samples.high;
    field.standard = technique.samples.standard;
    field.whole = true;
    field.value = variant.samples;
    if (const auto value = number_field(desk, field)) {
        const int samples = allowed_samples(technique, static_cast<int>(*value));
        edit(desk, side, "samples", [&](Variant& to) { to.samples = samples; });
    }
}

void denoise_menu(Desk& desk, char side, const Technique& technique, const Variant& variant) {
    if (!technique.makes_accessibility()) return;
    std::vector<std::string> names;
    std::vector<std::string> citations;
    for (const renderer::Denoise& denoise : renderer::denoise_filters()) {
        names.push_back(denoise.name);
        citations.push_back(denoise.citation);
    }
    const auto chosen =
        choice_field(desk, "denoise", "Filter of the accessibility buffer", names, variant.denoise,
                     citations, renderer::standard_denoise(technique));
    if (chosen) edit(desk, side, "", [&](Variant& to) { to.denoise = *chosen; });
}

void option_menus(Desk& desk, char side, const Variant& variant) {
    for (const renderer::VariantOption& option : renderer::variant_options()) {
        const auto chosen = choice_field(desk, option.name, option.meaning, option.allowed,
                                         variant.*option.value, {}, option.standard());
        if (chosen) edit(desk, side, "", [&](Variant& to) { to.*option.value = *chosen; });
    }
}

void parameter_fields(Desk& desk, char side, const Technique& technique, const Variant& variant) {
    for (const renderer::Parameter& parameter : technique.parameters) {
        NumberField field{
            parameter.name, parameter.meaning,  parameter.unit,  parameter.low,
            parameter.high, parameter.standard, parameter.whole, variant.value_of(parameter)};
        const auto value = number_field(desk, field);
        if (!value) continue;
        edit(desk, side, parameter.name, [&](Variant& to) {
            if (*value == parameter.standard) {
                to.parameters.erase(parameter.name);
            } else {
                to.parameters[parameter.name] = *value;
            }
        });
    }
}

}  // namespace

void technique_panel(Desk& desk, char side) {
    const Variant variant = desk.model.choices().side(side);
    const Technique* technique = renderer::find_technique(variant.technique);
    ImGui::PushID(side);
    desk.state.panel = side;
    if (begin_fields("technique")) {
        technique_menu(desk, side, variant);
        preset_menu(desk, side, variant);
        samples_field(desk, side, *technique, variant);
        denoise_menu(desk, side, *technique, variant);
        option_menus(desk, side, variant);
        parameter_fields(desk, side, *technique, variant);
        end_fields();
    }
    if (ImGui::SmallButton("reset all")) {
        edit(desk, side, "", [&](Variant& to) {
            to = renderer::standard_variant(*technique);
            to.denoise = renderer::standard_denoise(*technique);
        });
    }
    ImGui::SameLine();
    const char other = side == 'a' ? 'b' : 'a';
    if (ImGui::SmallButton(side == 'a' ? "take B's" : "take A's")) {
        const Variant of_other = desk.model.choices().side(other);
        edit(desk, side, "", [&](Variant& to) { to = of_other; });
    }
    ImGui::SameLine();
    ImGui::TextDisabled("%d fetches a pixel", renderer::fetches_per_pixel(variant));
    ImGui::PopID();
}

}  // namespace obscura::app::explorer
