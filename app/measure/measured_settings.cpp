// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/measured_settings.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "renderer/technique/variant_setting.h"

namespace obscura::app {
namespace {

using renderer::Parameter;
using renderer::Technique;
using renderer::Variant;

const std::vector<int> kSamples{8, 16, 24, 32, 64};
const std::vector<int> kQuickSamples{8, 24, 64};

/// What is wrong with so many samples of a technique; nothing where it takes them.
std::optional<std::string> problem_of(const Technique& technique, int samples) {
    const renderer::Variant variant{.technique = technique.name, .samples = samples};
    for (const renderer::VariantProblem& problem : renderer::problems_of(variant)) {
        if (problem.key == "samples") return problem.message;
    }
    return std::nullopt;
}

/// With the request's own settings in place of others.
Variant as_asked(Variant variant, const MeasureRequest& request) {
    const Technique& technique = *renderer::find_technique(variant.technique);
    if (request.radius_m && technique.find_parameter(kTruthRadius) != nullptr) {
        variant.parameters[kTruthRadius] = *request.radius_m;
    }
    for (const std::string& setting : request.settings) {
        if (has_setting(variant, setting.substr(0, setting.find('=')))) {
            (void)renderer::set(variant, setting);
        }
    }
    return variant;
}

/// Those asked for; else the usual one, and the technique's own where it has one.
std::vector<std::string> filters_of(const MeasureRequest& request, const Technique& technique) {
    if (!request.filters.empty()) return request.filters;
    const std::string own = renderer::standard_denoise(technique);
    if (request.quick || own == kPlottedFilter || own == "none") return {kPlottedFilter};
    return {kPlottedFilter, own};
}

bool is_among(const std::vector<Valued>& list, const Variant& choice) {
    return std::any_of(list.begin(), list.end(),
                       [&](const Valued& held) { return held.choice == choice; });
}

bool same_parameters(const Variant& a, const Variant& b) {
    Variant like_a = b;
    like_a.samples = a.samples;
    like_a.denoise = a.denoise;
    for (const renderer::VariantOption& option : renderer::variant_options()) {
        like_a.*option.value = a.*option.value;
    }
    return a == like_a;
}

/// Whether a value of one technique's parameter says something of another's: R does, and what has
/// the same meaning. An exponent of something else does not.
bool mean_the_same(const Technique& a, const Technique& b, const std::string& name) {
    const Parameter* of_a = a.find_parameter(name);
    const Parameter* of_b = b.find_parameter(name);
    if (of_a == nullptr || of_b == nullptr) return false;
    return name == kTruthRadius || of_a->meaning == of_b->meaning;
}

/// Of those that show the technique, one for each set of parameters.
std::vector<Valued> ways_of(const std::vector<ShownSetting>& shown, const std::string& technique) {
    std::vector<Valued> ways;
    for (const ShownSetting& setting : shown) {
        if (setting.choice.technique != technique) continue;
        const bool there = std::any_of(ways.begin(), ways.end(), [&](const Valued& way) {
            return same_parameters(way.choice, setting.choice);
        });
        if (!there) ways.push_back({setting.choice, Values::kPublished});
    }
    return ways;
}

/// The numbers of samples to measure a technique with: those asked for; else the usual ones and the
/// papers' own, which the order of the techniques is read from.
std::set<int> samples_of(const MeasureRequest& request, const Technique& technique) {
    const std::vector<int>& list = !request.samples.empty() ? request.samples
                                   : request.quick          ? kQuickSamples
                                                            : kSamples;
    std::set<int> wanted(list.begin(), list.end());
    if (request.samples.empty()) wanted.insert(technique.samples.standard);
    std::erase_if(wanted, [&](int samples) { return problem_of(technique, samples).has_value(); });
    return wanted;
}

template <typename Value>
bool is_wanted(const std::vector<Value>& list, const Value& value) {
    return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

std::string to_string(Values values) {
    switch (values) {
        case Values::kPublished:
            return "published";
        case Values::kStandard:
            return "standard";
        case Values::kStart:
            return "start";
        case Values::kAsked:
            return "asked";
        case Values::kFitted:
            return "fitted";
    }
    return "";
}

bool has_setting(const Variant& variant, const std::string& key) {
    return renderer::find_option(key) != nullptr ||
           renderer::find_technique(variant.technique)->find_parameter(key) != nullptr;
}

std::vector<std::string> left_out_of(const MeasureRequest& request) {
    std::vector<std::string> sentences;
    if (request.techniques.empty()) {
        for (const Technique& technique : renderer::techniques()) {
            const std::string why = why_unmeasured(technique);
            if (!why.empty()) sentences.push_back(technique.name + " " + why + ": not measured");
        }
    }
    if (!request.samples.empty()) return sentences;
    for (const std::string& name : measured_techniques(request)) {
        const Technique& technique = *renderer::find_technique(name);
        if (technique.samples.high == 0) continue;
        std::vector<int> refused;
        for (const int samples : request.quick ? kQuickSamples : kSamples) {
            if (problem_of(technique, samples)) refused.push_back(samples);
        }
        if (refused.empty()) continue;
        sentences.push_back(fmt::format("{} does not take {} samples: those are left out", name,
                                        fmt::join(refused, ", ")));
    }
    return sentences;
}

std::vector<Valued> published_choices(const MeasuredView& view, const stimuli::Study& study,
                                      const std::string& technique) {
    std::vector<Valued> ways = ways_of(view.shown, technique);
    if (!ways.empty()) return ways;
    const std::vector<ShownSetting> here = shown_on(study, view.scene->source);
    ways = ways_of(here, technique);
    if (!ways.empty()) return {ways.front()};
    const Technique& descriptor = *renderer::find_technique(technique);
    Valued made{{}, Values::kStandard};
    made.choice.technique = technique;
    made.choice.samples = descriptor.samples.standard;
    made.choice.denoise = descriptor.samples.high > 0 ? kPlottedFilter : "none";
    const auto everywhere = [](const stimuli::StudyScene&) { return true; };
    ways = ways_of(settings_shown(study, everywhere), technique);
    if (!ways.empty()) made = {ways.front().choice, Values::kStart};
    // With no parameters nothing comes from that other scene.
    if (made.choice.parameters.empty()) made.values = Values::kStandard;
    for (const ShownSetting& setting : here) {
        for (const auto& [name, value] : setting.choice.parameters) {
            if (!mean_the_same(descriptor, *renderer::find_technique(setting.choice.technique),
                               name)) {
                continue;
            }
            made.choice.parameters[name] = value;
            if (made.values == Values::kStandard) made.values = Values::kPublished;
        }
    }
    return {made};
}

renderer::Variant on_view(renderer::Variant variant, const MeasuredView& view,
                          const stimuli::Study& study) {
    const Valued way = published_choices(view, study, variant.technique).front();
    for (const auto& [name, value] : way.choice.parameters) {
        variant.parameters.emplace(name, value);
    }
    return variant;
}

double truth_radius_m(const MeasuredView& view, const Variant& choice) {
    const Parameter* radius =
        renderer::find_technique(choice.technique)->find_parameter(kTruthRadius);
    return radius != nullptr ? choice.value_of(*radius) : view.radius_m;
}

std::vector<Valued> settings_of(const MeasureRequest& request, const MeasuredView& view,
                                const stimuli::Study& study) {
    std::vector<Valued> settings;
    const auto add = [&](const Variant& before, Values values) {
        const Variant choice = as_asked(before, request);
        if (choice != before) values = Values::kAsked;
        if (!is_among(settings, choice)) settings.push_back({choice, values});
    };
    const bool says_which = !request.samples.empty() || !request.filters.empty();
    for (const std::string& name : measured_techniques(request)) {
        const Technique& technique = *renderer::find_technique(name);
        const std::vector<Valued> ways = published_choices(view, study, name);
        for (const Valued& way : ways) {
            Variant choice = way.choice;
            if (technique.samples.high == 0) {
                add(choice, way.values);
                continue;
            }
            // The other ways in which a study shows a technique get the settings it shows; all of
            // those that were asked for where some were.
            if (&way != &ways.front() && !says_which) continue;
            for (const std::string& filter : filters_of(request, technique)) {
                choice.denoise = filter;
                for (const int count : samples_of(request, technique)) {
                    choice.samples = count;
                    add(choice, way.values);
                }
            }
        }
        // Half-float depth, on what the study shows or would show.
        if (!request.quick && request.samples.empty() &&
            technique.standard_recipe().reads(renderer::Target::kDepth)) {
            Variant choice = ways.front().choice;
            choice.depth_format = "r16f";
            if (renderer::problems_of(choice).empty()) add(choice, ways.front().values);
        }
    }
    const std::vector<std::string> techniques = measured_techniques(request);
    for (const ShownSetting& setting : view.shown) {
        const Variant& choice = setting.choice;
        const bool measured = is_wanted(techniques, choice.technique) &&
                              (choice.samples == 0 || (is_wanted(request.samples, choice.samples) &&
                                                       is_wanted(request.filters, choice.denoise)));
        if (measured) add(choice, Values::kPublished);
    }
    return settings;
}

std::string why_unmeasured(const Technique& technique) {
    if (technique.is_truth()) return "is the truth that the others are held against";
    if (technique.output == renderer::Output::kColour) {
        return "makes colour and no accessibility, which has no error";
    }
    return "";
}

std::vector<std::string> measured_techniques(const MeasureRequest& request) {
    if (!request.techniques.empty()) return request.techniques;
    std::vector<std::string> names;
    for (const Technique& technique : renderer::techniques()) {
        if (why_unmeasured(technique).empty()) names.push_back(technique.name);
    }
    return names;
}

}  // namespace obscura::app
