// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/variant.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "renderer/base/nearest.h"
#include "renderer/denoise/denoise.h"
#include "renderer/recipe/depth_beside.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {
namespace {

using Problems = std::vector<VariantProblem>;

template <typename List>
std::string names_of(const List& list) {
    std::string names;
    for (const auto& item : list) names += (names.empty() ? "" : ", ") + item.name;
    return names.empty() ? "none" : names;
}

/// What the number of samples is a multiple of; 1 where the parameter that says so is wrong itself.
int multiple_of(const Technique& technique, const Variant& variant) {
    const SampleRange& range = technique.samples;
    if (range.times.empty()) return range.multiple_of;
    const Parameter& times = *technique.find_parameter(range.times);
    const double value = variant.value_of(times);
    const bool sound = value >= times.low && value <= times.high && value == std::floor(value);
    return sound ? range.multiple_of * static_cast<int>(value) : 1;
}

void check_samples(const Technique& technique, const Variant& variant, Problems& problems) {
    const SampleRange& range = technique.samples;
    const int samples = variant.samples;
    const int multiple = multiple_of(technique, variant);
    if (samples < range.low || samples > range.high) {
        problems.push_back(
            {"samples",
             range.high == 0
                 ? fmt::format("{} is not allowed: {} takes no samples", samples, technique.name)
                 : fmt::format("{} is out of range: {} takes {} to {}", samples, technique.name,
                               range.low, range.high)});
    } else if (samples % multiple != 0) {
        problems.push_back(
            {"samples",
             fmt::format("{} is not allowed: {} takes multiples of {}{}", samples, technique.name,
                         multiple, range.times.empty() ? "" : " at its number of " + range.times)});
    }
}

void check_denoise(const Technique& technique, const std::string& denoise, Problems& problems) {
    if (find_denoise(denoise) == nullptr) {
        problems.push_back({"denoise", fmt::format("\"{}\" is unknown; allowed are {}", denoise,
                                                   names_of(denoise_filters()))});
    } else if (!technique.makes_accessibility() && denoise != "none") {
        problems.push_back({"denoise", fmt::format("\"{}\" is not allowed: {} has no buffer to "
                                                   "smooth",
                                                   denoise, technique.name)});
    }
}

/// Why a technique does not have an option; empty where it has.
std::string why_without(const Technique& technique, const std::string& option,
                        const std::string& value) {
    if (option == "pipeline") return "";
    if (option == "frames") return why_not_progressive(technique);
    if (option == "depth_format") {
        const bool starts_rays = technique.ray_traced && !technique.is_truth();
        if (!starts_rays) return "";
        return fmt::format("starts its rays from the depth, and {} bits put them inside surfaces",
                           value == "d24" ? 24 : 16);
    }
    if (!technique.makes_accessibility()) return "has no buffer of accessibility";
    if (technique.is_truth()) return "is the truth, which is shown as it is";
    if (option == "noise" && technique.ray_traced) return "has points of its own for its rays";
    if (option == "position" && technique.ray_traced) return "starts its rays from the depth";
    if (option == "position" && !technique.standard_recipe().reads(Target::kPosition)) {
        return "works in the image and needs no points of view space";
    }
    return "";
}

/// Whether every frame can have as many samples.
void check_frames(const Technique& technique, const Variant& variant, Problems& problems) {
    const int frames = frames_of(variant);
    if (!why_not_progressive(technique).empty()) return;
    const int multiple = multiple_of(technique, variant);
    if (variant.samples % (frames * multiple) == 0 &&
        variant.samples / frames >= technique.samples.low) {
        return;
    }
    problems.push_back(
        {"frames",
         fmt::format("{} is not allowed with {} samples: frames share them evenly, each at "
                     "least {}, and {} takes multiples of {} a frame",
                     frames, variant.samples, technique.samples.low, technique.name, multiple)});
}

void check_options(const Variant& variant, Problems& problems) {
    const Technique& technique = *find_technique(variant.technique);
    for (const VariantOption& option : variant_options()) {
        const std::string& value = variant.*option.value;
        const auto& allowed = option.allowed;
        if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
            problems.push_back({option.name, fmt::format("\"{}\" is unknown; allowed are {}", value,
                                                         fmt::join(allowed, ", "))});
            continue;
        }
        if (value == option.standard()) continue;
        if (option.name == "frames") check_frames(technique, variant, problems);
        const std::string why = why_without(technique, option.name, value);
        if (why.empty()) continue;
        problems.push_back(
            {option.name, fmt::format("\"{}\" is not allowed: {} {}", value, technique.name, why)});
    }
}

void check_parameter(const Technique& technique, const std::string& name, double value,
                     Problems& problems) {
    const Parameter* parameter = technique.find_parameter(name);
    if (parameter == nullptr) {
        problems.push_back({name, fmt::format("{} has no such parameter; allowed are {}",
                                              technique.name, names_of(technique.parameters))});
    } else if (!(value >= parameter->low && value <= parameter->high)) {
        problems.push_back(
            {name,
             fmt::format("{} is out of range: allowed is {} to {}{}{}", value, parameter->low,
                         parameter->high, parameter->unit.empty() ? "" : " ", parameter->unit)});
    } else if (parameter->whole && value != std::floor(value)) {
        problems.push_back({name, fmt::format("{} is not a whole number from {} to {}", value,
                                              parameter->low, parameter->high)});
    }
}

}  // namespace

const std::vector<VariantOption>& variant_options() {
    static const std::vector<VariantOption> list = {
        {"depth_format",
         "How the depth that the technique reads is stored; d24: rebuilt from the depth test's",
         {"r32f", "r16f", "d24"},
         &Variant::depth_format},
        {"normal_format",
         "How the normal that the technique reads is stored; rg8: z rebuilt; oct16: octahedral; "
         "from-depth: rebuilt from neighbours' depths",
         {"rgb8", "rg8", "oct16", "from-depth"},
         &Variant::normal_format},
        {"noise",
         "What turns the samples from pixel to pixel: a tile of 4x4, blue noise, or R2 points "
         "along a Hilbert curve, both over 64x64",
         {"tile4x4", "blue64", "hilbert64"},
         &Variant::noise},
        {"ao_scale",
         "Width and height of the accessibility buffer, of the image's; brought up by depth",
         {"1", "0.5", "0.25"},
         &Variant::ao_scale,
         true},
        {"ao_format", "How accessibility is stored", {"r32f", "r16f", "r8"}, &Variant::ao_format},
        {"position",
         "How points of view space come about: from the depth by similar triangles, from it "
         "through the inverse of the projection, or stored in place of it in as many bits a "
         "component",
         {"similar-triangles", "inverse-projection", "stored"},
         &Variant::position},
        {"frames",
         "Progressive: the kernel is spread over that many frames, whose mean is shown",
         {"1", "2", "3", "4", "6", "8", "12", "16"},
         &Variant::frames,
         true},
        {"pipeline",
         "g-buffer: surfaces are drawn once and lit from buffers; nd-buffer: normal and depth "
         "first, then surfaces once more, lit as they are drawn",
         {"g-buffer", "nd-buffer"},
         &Variant::pipeline},
    };
    return list;
}

std::string options_in_words(const Variant& variant) {
    std::string words;
    for (const VariantOption& option : variant_options()) {
        const std::string& value = variant.*option.value;
        if (value == option.standard()) continue;
        words += fmt::format("{}{} {}", words.empty() ? "" : ", ", option.name, value);
    }
    return words;
}

bool same_options(const Variant& a, const Variant& b) {
    return std::all_of(
        variant_options().begin(), variant_options().end(),
        [&](const VariantOption& option) { return a.*option.value == b.*option.value; });
}

int ao_step(const Variant& variant) {
    return variant.ao_scale == "0.25" ? 4 : variant.ao_scale == "0.5" ? 2 : 1;
}

int frames_of(const Variant& variant) {
    int frames = 1;
    std::from_chars(variant.frames.data(), variant.frames.data() + variant.frames.size(), frames);
    return std::max(frames, 1);
}

const VariantOption* find_option(std::string_view name) {
    for (const VariantOption& option : variant_options()) {
        if (option.name == name) return &option;
    }
    return nullptr;
}

std::string Variant::variant_name() const {
    const Technique* found = find_technique(technique);
    const std::string stem = found != nullptr ? found->variant : technique;
    return samples > 0 ? stem + std::to_string(samples) : stem;
}

double Variant::value_of(const Parameter& parameter) const {
    const auto set = parameters.find(parameter.name);
    return set != parameters.end() ? set->second : parameter.standard;
}

std::map<std::string, double> Variant::all_parameters() const {
    std::map<std::string, double> all = parameters;
    const Technique* found = find_technique(technique);
    if (found == nullptr) return all;
    for (const Parameter& parameter : found->parameters) {
        all.emplace(parameter.name, parameter.standard);
    }
    return all;
}

std::string Variant::in_words() const {
    std::string words = variant_name();
    if (const Technique* found = find_technique(technique)) {
        for (const Parameter& parameter : found->parameters) {
            words += fmt::format(", {} {}", parameter.name, value_of(parameter));
        }
    }
    words += ", denoise " + denoise;
    const std::string options = options_in_words(*this);
    return options.empty() ? words : words + ", " + options;
}

bool Variant::operator==(const Variant& other) const {
    return technique == other.technique && samples == other.samples && denoise == other.denoise &&
           unclamped == other.unclamped && all_parameters() == other.all_parameters() &&
           same_options(*this, other);
}

const std::vector<std::string>& preset_names() {
    static const std::vector<std::string> names = {"published", "fitted"};
    return names;
}

std::string apply_preset(const std::string& preset, Variant& variant) {
    const Technique* technique = find_technique(variant.technique);
    if (preset == preset_names().front()) return "";
    if (preset != preset_names().back()) {
        return fmt::format("\"{}\" is unknown; allowed are {}", preset,
                           fmt::join(preset_names(), ", "));
    }
    if (technique == nullptr) return "";
    if (technique->fitted.empty()) {
        return fmt::format("{} has no fitted values, only published ones", technique->name);
    }
    variant.parameters.insert(technique->fitted.begin(), technique->fitted.end());
    return "";
}

Variant standard_variant(const Technique& technique) {
    Variant variant;
    variant.technique = technique.name;
    variant.samples = technique.samples.standard;
    return variant;
}

std::string standard_denoise(const Technique& technique) {
    return technique.makes_accessibility() && !technique.is_truth() ? technique.denoise : "none";
}

int fetches_per_pixel(const Variant& variant) {
    const Technique* technique = find_technique(variant.technique);
    const Denoise* denoise = find_denoise(variant.denoise);
    if (technique == nullptr || technique->recipe == nullptr) return 0;
    Recipe recipe = recipe_of(*technique, variant);
    if (denoise == nullptr) return fetches_per_pixel(recipe);
    Recipe filter = denoise->recipe;
    (void)lay_depth_beside(variant.ao_format, recipe, filter);
    return fetches_per_pixel(recipe) + fetches_per_pixel(filter);
}

std::vector<VariantProblem> problems_of(const Variant& variant) {
    const Technique* technique = find_technique(variant.technique);
    if (technique == nullptr) {
        std::vector<std::string> names;
        for (const Technique& one : techniques()) names.push_back(one.name);
        return {{"technique", fmt::format("\"{}\" is unknown; allowed are {}{}", variant.technique,
                                          names_of(techniques()),
                                          base::did_you_mean(variant.technique, names))}};
    }
    Problems problems;
    check_samples(*technique, variant, problems);
    check_denoise(*technique, variant.denoise, problems);
    check_options(variant, problems);
    for (const auto& [name, value] : variant.parameters) {
        check_parameter(*technique, name, value, problems);
    }
    return problems;
}

}  // namespace obscura::renderer
