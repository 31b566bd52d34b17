// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/view.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "renderer/base/check.h"
#include "renderer/denoise/denoise.h"
#include "renderer/reference/reference.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app {
namespace {

using renderer::Parameter;
using renderer::Technique;
using renderer::TechniqueChoice;

const std::vector<int> kSamples{8, 16, 24, 32, 64};
const std::vector<int> kQuickSamples{8, 24, 64};

template <typename List>
std::string names_of(const List& list) {
    std::vector<std::string> names;
    for (const auto& item : list) names.push_back(item.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Every setting that the study shows on scenes of that source.
std::vector<ShownSetting> shown_on(const stimuli::Study& study, const std::string& source,
                                   const std::string& camera, const stimuli::Validity* validity) {
    std::vector<ShownSetting> shown;
    for (const stimuli::Condition& condition : study.conditions) {
        const stimuli::StudyScene& scene = study.scene_of(condition);
        if (scene.source != source) continue;
        if (!camera.empty() && scene.camera != camera) continue;
        if (validity != nullptr && scene.validity != *validity) continue;
        shown.push_back({condition.id + " a", condition.a});
        shown.push_back({condition.id + " b", condition.b});
    }
    return shown;
}

/// The radius that the study gives to the techniques on a scene; the first technique's standard
/// radius where it gives none.
double radius_on(const stimuli::Study& study, const std::string& source) {
    for (const ShownSetting& setting : shown_on(study, source, "", nullptr)) {
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

View make_view(Source scene, const std::string& camera, stimuli::Validity validity,
               const stimuli::Study& study, const renderer::FrameOptions& options) {
    const double radius_m = radius_on(study, scene->source);
    std::vector<ShownSetting> shown = shown_on(study, scene->source, camera, &validity);
    return {std::move(scene), camera, validity, radius_m, options, std::move(shown)};
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

bool allows(const Technique& technique, int samples) {
    const renderer::SampleRange& range = technique.samples;
    return samples >= range.low && samples <= range.high && samples % range.multiple_of == 0;
}

void check_samples(const MeasureRequest& request) {
    for (const int samples : request.samples) {
        base::check_range("measure", "--samples", samples, 1, 65536);
        for (const std::string& name : measured_techniques(request)) {
            const Technique& technique = *renderer::find_technique(name);
            if (technique.samples.high == 0 || allows(technique, samples)) continue;
            throw base::bad_input(
                "--samples: {} is not allowed for {}, which takes {} to {}{}", samples, name,
                technique.samples.low, technique.samples.high,
                technique.samples.multiple_of > 1
                    ? fmt::format(" in multiples of {}", technique.samples.multiple_of)
                    : "");
        }
    }
}

std::vector<std::string> filters_of(const MeasureRequest& request) {
    if (!request.filters.empty()) return request.filters;
    if (request.quick) return {kPlottedFilter};
    std::vector<std::string> filters;
    for (const renderer::Denoise& filter : renderer::denoise_filters()) {
        filters.push_back(filter.name);
    }
    return filters;
}

}  // namespace

std::vector<View> views_of(const MeasureRequest& request, const stimuli::Study& study,
                           const std::vector<stimuli::BuiltinScene>& catalogue) {
    std::vector<View> views;
    if (request.scenes.empty()) {
        std::map<std::string, Source> sources;
        std::set<std::string> seen;
        for (const stimuli::StudyScene& scene : study.scenes) {
            const std::string key = scene.source + ' ' + stimuli::to_json(scene.settings);
            if (!seen.insert(fmt::format("{} {} {}", key, scene.camera,
                                         stimuli::to_string(scene.validity)))
                     .second) {
                continue;
            }
            if (!sources.contains(key)) {
                sources.emplace(key, scene_of_study(catalogue, study, scene));
            }
            views.push_back(make_view(sources.at(key), scene.camera, scene.validity, study,
                                      study.frame_options()));
        }
    }
    for (const std::string& id : request.scenes) {
        const Source scene = named_scene(catalogue, id);
        for (const std::string& camera : scene->cameras) {
            views.push_back(make_view(scene, camera, scene->levels.front(), study, {}));
        }
    }
    return views;
}

TechniqueChoice published_choice(const View& view, const stimuli::Study& study,
                                 const std::string& technique) {
    const Technique& descriptor = *renderer::find_technique(technique);
    TechniqueChoice choice;
    choice.technique = technique;
    choice.samples = descriptor.samples.standard;
    choice.denoise = descriptor.samples.high > 0 ? kPlottedFilter : "none";
    const std::vector<ShownSetting> here = shown_on(study, view.scene->source, "", nullptr);
    for (const auto* list : {&view.shown, &here}) {
        for (const ShownSetting& setting : *list) {
            if (setting.choice.technique == technique) return setting.choice;
        }
    }
    for (const stimuli::Condition& condition : study.conditions) {
        for (const TechniqueChoice* shown : {&condition.a, &condition.b}) {
            if (shown->technique != technique) continue;
            choice = *shown;
            break;
        }
    }
    for (const ShownSetting& setting : here) {
        for (const auto& [name, value] : setting.choice.parameters) {
            if (descriptor.find_parameter(name) != nullptr) choice.parameters[name] = value;
        }
    }
    return choice;
}

double truth_radius_m(const View& view, const TechniqueChoice& published) {
    const Parameter* radius =
        renderer::find_technique(published.technique)->find_parameter("radius_m");
    return radius != nullptr ? published.value_of(*radius) : view.radius_m;
}

std::vector<TechniqueChoice> settings_of(const MeasureRequest& request, const View& view,
                                         const stimuli::Study& study) {
    std::vector<TechniqueChoice> settings;
    const auto add = [&settings](const TechniqueChoice& choice) {
        if (std::find(settings.begin(), settings.end(), choice) == settings.end()) {
            settings.push_back(choice);
        }
    };
    const std::vector<int> samples = !request.samples.empty() ? request.samples
                                     : request.quick          ? kQuickSamples
                                                              : kSamples;
    for (const std::string& name : measured_techniques(request)) {
        const Technique& technique = *renderer::find_technique(name);
        TechniqueChoice choice = published_choice(view, study, name);
        if (technique.samples.high == 0) {
            add(choice);
            continue;
        }
        for (const std::string& filter : filters_of(request)) {
            choice.denoise = filter;
            std::set<int> wanted(samples.begin(), samples.end());
            // The papers' own number always: it is what the order of the techniques is read from.
            if (request.samples.empty()) wanted.insert(technique.samples.standard);
            for (const int count : wanted) {
                choice.samples = count;
                if (allows(technique, count)) add(choice);
            }
        }
        // Half-float depth, on what the study shows or would show.
        if (!request.quick && request.samples.empty() &&
            technique.standard_recipe().reads(renderer::Target::kDepth)) {
            choice = published_choice(view, study, name);
            choice.depth_format = "r16f";
            add(choice);
        }
    }
    const std::vector<std::string> techniques = measured_techniques(request);
    for (const ShownSetting& setting : view.shown) {
        const bool wanted = std::find(techniques.begin(), techniques.end(),
                                      setting.choice.technique) != techniques.end();
        if (wanted && request.samples.empty() && request.filters.empty()) add(setting.choice);
    }
    return settings;
}

std::vector<std::string> measured_techniques(const MeasureRequest& request) {
    if (!request.techniques.empty()) return request.techniques;
    std::vector<std::string> names;
    for (const Technique& technique : renderer::techniques()) {
        if (!technique.ray_traced) names.push_back(technique.name);
    }
    return names;
}

void check_request(const MeasureRequest& request) {
    for (const std::string& name : request.techniques) {
        const Technique* technique = renderer::find_technique(name);
        if (technique == nullptr) {
            throw base::bad_input("--techniques: \"{}\" is unknown, allowed are {}", name,
                                  names_of(renderer::techniques()));
        }
        if (technique->ray_traced) {
            throw base::bad_input("--techniques: {} is the truth that the others are held against",
                                  name);
        }
    }
    for (const std::string& name : request.filters) {
        if (renderer::find_denoise(name) == nullptr) {
            throw base::bad_input("--filters: \"{}\" is unknown, allowed are {}", name,
                                  names_of(renderer::denoise_filters()));
        }
    }
    check_samples(request);
    base::check_range("measure", "--size, width", request.width, 1, 16384);
    base::check_range("measure", "--size, height", request.height, 1, 16384);
    base::check_range("measure", "--rays", request.rays, 1, renderer::kMostReferenceRays);
    base::check_range("measure", "--runs", request.runs, 1, 1000);
    if (!request.write_study.empty() && !request.fit) {
        throw base::bad_input("--write-study: there are fitted values only with --fit");
    }
    if (!request.write_study.empty() && !request.scenes.empty()) {
        throw base::bad_input(
            "--write-study: it writes a copy of the study, and --scene measures "
            "scenes without one");
    }
}

}  // namespace obscura::app
