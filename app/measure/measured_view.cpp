// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/measured_view.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "renderer/base/error.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app {
namespace {

using renderer::Parameter;
using renderer::Technique;

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
    view.shown = settings_shown(study, [&](const auto& other) { return other.id == scene.id; });
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
Source named_scene(const std::vector<stimuli::BuiltinScene>& catalogue, const std::string& source,
                   double scale) {
    if (Source builtin = find_builtin(catalogue, source)) return builtin;
    if (stimuli::is_file_source(source)) {
        stimuli::SceneSettings settings;
        settings.scale = scale;
        return std::make_shared<const stimuli::SceneSource>(
            stimuli::source_of(stimuli::open_scene(source, settings, {}, catalogue), source));
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

}  // namespace

std::vector<ShownSetting> settings_shown(
    const stimuli::Study& study, const std::function<bool(const stimuli::StudyScene&)>& wanted) {
    std::vector<ShownSetting> shown;
    for (const stimuli::Condition& condition : study.conditions) {
        if (!wanted(study.scene_of(condition))) continue;
        shown.push_back({condition.id + " a", condition.a});
        shown.push_back({condition.id + " b", condition.b});
    }
    return shown;
}

std::vector<ShownSetting> shown_on(const stimuli::Study& study, const std::string& source) {
    return settings_shown(study,
                          [&](const stimuli::StudyScene& scene) { return scene.source == source; });
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
        const Source scene = named_scene(catalogue, id, request.scale);
        for (const std::string& camera : scene->cameras) {
            views.push_back(make_view(scene, camera, study));
        }
    }
    for (MeasuredView& view : views) view.radius_m = request.radius_m.value_or(view.radius_m);
    if (request.cameras.empty()) return views;
    std::vector<std::string> known;
    for (const MeasuredView& view : views) known.push_back(view.camera);
    for (const std::string& camera : request.cameras) {
        if (std::find(known.begin(), known.end(), camera) == known.end()) {
            throw base::bad_input("--camera: there is no camera \"{}\", allowed are {}", camera,
                                  fmt::join(known, ", "));
        }
    }
    std::erase_if(views, [&](const MeasuredView& view) {
        return std::find(request.cameras.begin(), request.cameras.end(), view.camera) ==
               request.cameras.end();
    });
    return views;
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

}  // namespace obscura::app
