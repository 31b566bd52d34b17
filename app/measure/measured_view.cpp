// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/measured_view.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "renderer/base/error.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app {
namespace {

using renderer::Parameter;
using renderer::Technique;
using renderer::Variant;

const std::vector<int> kSamples{8, 16, 24, 32, 64};
const std::vector<int> kQuickSamples{8, 24, 64};

/// Every setting that the study shows on the scenes that `wanted` holds.
template <typename Wanted>
std::vector<ShownSetting> shown_where(const stimuli::Study& study, const Wanted& wanted) {
    std::vector<ShownSetting> shown;
    for (const stimuli::Condition& condition : study.conditions) {
        if (!wanted(study.scene_of(condition))) continue;
        shown.push_back({condition.id + " a", condition.a});
        shown.push_back({condition.id + " b", condition.b});
    }
    return shown;
}

/// On scenes of that source.
std::vector<ShownSetting> shown_on(const stimuli::Study& study, const std::string& source) {
    return shown_where(study, [&](const auto& scene) { return scene.source == source; });
}

/// The radius that the study gives to the techniques on a scene; the first technique's standard
/// radius where it gives none.
double radius_on(const stimuli::Study& study, const std::string& source) {
    for (const ShownSetting& setting : shown_on(study, source)) {
        const auto radius = setting.choice.parameters.find("radius_m");
        if (radius != setting.choice.parameters.end()) return radius->second;
    }
    for (const Technique& technique : renderer::techniques()) {
        if (const Parameter* radius = technique.find_parameter("radius_m")) {
            return radius->standard;
        }
    }
    return 0.5;
}

using Source = std::shared_ptr<const stimuli::SceneSource>;

/// A view of the study.
MeasuredView make_view(Source source, const stimuli::StudyScene& scene,
                       const stimuli::Study& study) {
    MeasuredView view;
    view.scene_id = scene.id;
    view.camera = scene.camera;
    view.validity = scene.validity;
    view.radius_m = radius_on(study, source->source);
    view.options = study.frame_options();
    view.shown = shown_where(study, [&](const auto& other) { return other.id == scene.id; });
    view.scene = std::move(source);
    return view;
}

/// A view of a scene without a study; `study` lends the values to begin with.
MeasuredView make_view(Source source, const std::string& camera, const stimuli::Study& study) {
    MeasuredView view;
    view.scene_id = source->id;
    view.camera = camera;
    view.validity = source->levels.front();
    view.radius_m = radius_on(study, source->source);
    view.scene = std::move(source);
    return view;
}

/// A built-in scene as it is, built when it is first looked at; nothing for another source.
Source find_builtin(const std::vector<stimuli::BuiltinScene>& catalogue,
                    const std::string& source) {
    for (const stimuli::BuiltinScene& scene : catalogue) {
        if (scene.id != source) continue;
        return std::make_shared<const stimuli::SceneSource>(stimuli::SceneSource{
            scene.id, scene.id, scene.cameras, scene.levels, scene.build, scene.lighting});
    }
    return nullptr;
}

/// What `--scene` names.
Source named_scene(const std::vector<stimuli::BuiltinScene>& catalogue, const std::string& source) {
    if (Source builtin = find_builtin(catalogue, source)) return builtin;
    if (stimuli::is_file_source(source)) {
        return std::make_shared<const stimuli::SceneSource>(
            stimuli::source_of(stimuli::open_scene(source, {}, {}, catalogue), source));
    }
    std::vector<std::string> ids;
    for (const stimuli::BuiltinScene& scene : catalogue) ids.push_back(scene.id);
    throw base::bad_input("--scene: there is no scene \"{}\", allowed are {} and glTF or OBJ files",
                          source, fmt::join(ids, ", "));
}

/// A scene as the study uses it, with what it says of camera and light.
Source scene_of_study(const std::vector<stimuli::BuiltinScene>& catalogue,
                      const stimuli::Study& study, const stimuli::StudyScene& scene) {
    const bool plain =
        stimuli::to_json(scene.settings) == stimuli::to_json(stimuli::SceneSettings{});
    if (plain) {
        if (Source builtin = find_builtin(catalogue, scene.source)) return builtin;
    }
    stimuli::SceneSource source = stimuli::source_of(
        stimuli::open_scene(scene.source, scene.settings, study.folder, catalogue), scene.source);
    if (scene.settings.camera) {
        renderer::Camera own = *scene.settings.camera;
        own.name = stimuli::kStudyCamera;
        source.cameras.push_back(own.name);
        source.build = [build = source.build, own] {
            renderer::Scene built = build();
            built.cameras.push_back(own);
            return built;
        };
    }
    return std::make_shared<const stimuli::SceneSource>(std::move(source));
}

/// What is wrong with so many samples of a technique; nothing where it takes them.
std::optional<std::string> problem_of(const Technique& technique, int samples) {
    const renderer::Variant variant{.technique = technique.name, .samples = samples};
    for (const renderer::VariantProblem& problem : renderer::problems_of(variant)) {
        if (problem.key == "samples") return problem.message;
    }
    return std::nullopt;
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

template <typename Value>
bool is_wanted(const std::vector<Value>& list, const Value& value) {
    return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
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

}  // namespace

std::string to_string(Values values) {
    switch (values) {
        case Values::kPublished:
            return "published";
        case Values::kStandard:
            return "standard";
        case Values::kStart:
            return "start";
        case Values::kFitted:
            return "fitted";
    }
    return "";
}

std::vector<MeasuredView> views_of(const MeasureRequest& request, const stimuli::Study& study,
                                   const std::vector<stimuli::BuiltinScene>& catalogue) {
    std::vector<MeasuredView> views;
    if (request.scenes.empty()) {
        std::map<std::string, Source> sources;
        for (const stimuli::StudyScene& scene : study.scenes) {
            const std::string key = scene.source + ' ' + stimuli::to_json(scene.settings);
            if (!sources.contains(key)) {
                sources.emplace(key, scene_of_study(catalogue, study, scene));
            }
            views.push_back(make_view(sources.at(key), scene, study));
        }
    }
    for (const std::string& id : request.scenes) {
        const Source scene = named_scene(catalogue, id);
        for (const std::string& camera : scene->cameras) {
            views.push_back(make_view(scene, camera, study));
        }
    }
    return views;
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
    ways = ways_of(shown_where(study, everywhere), technique);
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

std::vector<MeasuredView> one_a_scene(const std::vector<MeasuredView>& views) {
    std::vector<MeasuredView> kept;
    for (const MeasuredView& view : views) {
        const bool seen = std::any_of(kept.begin(), kept.end(), [&view](const auto& other) {
            return other.scene == view.scene;
        });
        if (!seen) kept.push_back(view);
    }
    return kept;
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
    const auto add = [&settings](const Variant& choice, Values values) {
        if (!is_among(settings, choice)) settings.push_back({choice, values});
    };
    const bool as_asked = !request.samples.empty() || !request.filters.empty();
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
            if (&way != &ways.front() && !as_asked) continue;
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
