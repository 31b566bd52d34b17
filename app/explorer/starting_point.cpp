// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/starting_point.h"

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/base/hash.h"
#include "renderer/import/import.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::app::explorer {
namespace {

constexpr const char* kFirstStudy = "jakobsen2010";

[[nodiscard]] bool is_study(const std::string& what) {
    return what.ends_with(".toml") || what == kFirstStudy;
}

/// No occlusion against the first technique that computes some.
void set_usual_pair(Choices& choices) {
    const auto& all = renderer::techniques();
    const auto first = std::find_if(all.begin(), all.end(), [](const auto& technique) {
        return technique.makes_accessibility() && technique.find_parameter("radius_m") != nullptr &&
               !technique.ray_traced;
    });
    choices.a = renderer::Variant{};
    if (first == all.end()) return;
    choices.b = renderer::standard_variant(*first);
    choices.b.denoise = renderer::standard_denoise(*first);
}

/// A pair of the study, without the study.
[[nodiscard]] StartingPoint pair_shown(const OpenStudy& study, const std::string& condition_id,
                                       const Choices& before) {
    const stimuli::Condition& condition = *study.study.find_condition(condition_id);
    StartingPoint start;
    start.choices = before;
    start.choices.scene = study.study.scene_of(condition);
    start.choices.folder = study.study.folder;
    start.choices.width = study.study.width;
    start.choices.height = study.study.height;
    start.choices.supersampling = study.study.supersampling;
    start.choices.occluding_opacity = study.study.occluding_opacity;
    start.choices.a = condition.a;
    start.choices.b = condition.b;
    start.choices.truth_radius_m.reset();
    start.camera = start.choices.scene.camera;
    start.own_camera = start.choices.scene.settings.camera;
    return start;
}

/// The pair that the built-in study shows of a scene, if it does.
[[nodiscard]] std::optional<StartingPoint> pair_of(const std::string& source,
                                                   const Choices& before) {
    const OpenStudy study = open_study(kFirstStudy);
    for (const stimuli::Condition& condition : study.study.conditions) {
        if (study.study.scene_of(condition).source != source) continue;
        return pair_shown(study, condition.id, before);
    }
    return std::nullopt;
}

[[nodiscard]] StartingPoint of_scene(const std::string& source, const Choices& before) {
    StartingPoint start;
    if (auto pair = pair_of(source, before)) {
        start = std::move(*pair);
    } else {
        start.choices = before;
        start.choices.scene = {};
        start.choices.folder.clear();
        start.choices.scene.source = source;
        start.choices.scene.validity = stimuli::Validity::kModerate;
        const bool has_pair = before.a.technique != "none" || before.b.technique != "none";
        if (!has_pair) set_usual_pair(start.choices);
    }
    start.choices.scene.id = source;
    return start;
}

[[nodiscard]] StartingPoint of_file(const std::string& file, const Choices& before) {
    StartingPoint start = of_scene(std::filesystem::absolute(file).string(), before);
    start.choices.scene.id = std::filesystem::path(file).stem().string();
    return start;
}

}  // namespace

OpenStudy open_study(const std::string& file_or_name) {
    const stimuli::StudySource source = stimuli::study_source(file_or_name);
    OpenStudy open;
    open.name = file_or_name;
    if (source.name.ends_with(".toml") || file_or_name.ends_with(".toml")) open.file = file_or_name;
    open.text_sha256 = base::sha256_hex(source.text);
    open.study = stimuli::parse_study(source.text, source.name, source.folder,
                                      stimuli::SceneFiles::kTrusted);
    return open;
}

StartingPoint starting_point(const OpenStudy& study, const std::string& condition_id,
                             const Choices& before) {
    StartingPoint start = pair_shown(study, condition_id, before);
    start.study = study;
    return start;
}

StartingPoint starting_point(const std::string& what, const Choices& before) {
    if (is_study(what)) {
        const OpenStudy study = open_study(what);
        return starting_point(study, study.study.conditions.front().id, before);
    }
    if (stimuli::find_builtin_scene(what) != nullptr) return of_scene(what, before);
    if (renderer::is_scene_file(what)) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(what, error)) {
            throw base::bad_input("cannot read {}: there is no such file", what);
        }
        return of_file(what, before);
    }
    std::string known;
    for (const stimuli::BuiltinScene& scene : stimuli::builtin_scenes()) known += scene.id + ", ";
    throw base::bad_input(
        "\"{}\" is no scene and no study: allowed are {}{}, a study file (.toml) and scenes that "
        "end in .gltf, .glb or .obj",
        what, known, kFirstStudy);
}

}  // namespace obscura::app::explorer
