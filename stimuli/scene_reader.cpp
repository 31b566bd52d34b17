// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "stimuli/scenes/backs.h"

namespace obscura::stimuli {
namespace {

using Need = TableReader::Need;
using Problems = std::vector<StudyProblem>;

constexpr double kFarthest_m = renderer::ImportLimits::kFarthest_m;
constexpr double kBrightest = 1e6;

glm::vec3 vector_of(const std::vector<double>& values) { return {values[0], values[1], values[2]}; }

/// Three numbers, or one that stands for all three.
std::optional<glm::vec3> read_colour(TableReader& reader, const std::string& key, double most) {
    const toml::node* value = reader.table().get(key);
    if (value == nullptr || value->is_number()) {
        const auto grey = reader.number(key, Need::kOptional, 0.0, most);
        if (!grey) return std::nullopt;
        return glm::vec3(static_cast<float>(*grey));
    }
    const std::vector<double> rgb = reader.numbers(key, Need::kOptional, 3, 0.0, most);
    if (rgb.empty()) return std::nullopt;
    return vector_of(rgb);
}

std::optional<glm::vec3> read_direction(TableReader& reader, Need need) {
    const std::vector<double> values = reader.numbers("direction", need, 3, -1e6, 1e6);
    if (values.empty()) return std::nullopt;
    const glm::vec3 direction = vector_of(values);
    if (!(glm::length(direction) > 1e-6F)) {
        reader.add("direction", "has no length, allowed is any other");
        return std::nullopt;
    }
    return glm::normalize(direction);
}

renderer::PointLight read_point_light(TableReader& reader, const glm::vec3& strength) {
    renderer::PointLight light;
    light.intensity = strength;
    const auto position =
        reader.numbers("position_m", Need::kRequired, 3, -kFarthest_m, kFarthest_m);
    if (!position.empty()) light.position_m = vector_of(position);
    light.range_m = static_cast<float>(reader.number("range_m", Need::kOptional, 1e-3, kFarthest_m)
                                           .value_or(std::numeric_limits<double>::infinity()));
    const auto cone = reader.number("cone_deg", Need::kOptional, 0.1, 90.0);
    if (const auto direction = read_direction(reader, cone ? Need::kRequired : Need::kOptional)) {
        light.direction = *direction;
        light.outer_cone_rad = glm::radians(static_cast<float>(cone.value_or(45.0)));
        light.inner_cone_rad = 0.8F * light.outer_cone_rad;  // a soft border
    }
    return light;
}

renderer::Camera read_view(const toml::table& table, const std::string& where, Problems& problems) {
    TableReader reader(table, where, problems);
    renderer::Camera camera;
    camera.name = kStudyCamera;
    const auto position =
        reader.numbers("position_m", Need::kRequired, 3, -kFarthest_m, kFarthest_m);
    const auto target = reader.numbers("target_m", Need::kRequired, 3, -kFarthest_m, kFarthest_m);
    if (!position.empty()) camera.position_m = vector_of(position);
    if (!target.empty()) camera.target_m = vector_of(target);
    camera.vertical_fov_rad = glm::radians(static_cast<float>(
        reader.number("vertical_fov_deg", Need::kRequired, 1.0, 170.0).value_or(45.0)));
    camera.near_m = static_cast<float>(
        reader.number("near_m", Need::kOptional, 1e-4, kFarthest_m).value_or(0.1));
    camera.far_m =
        static_cast<float>(reader.number("far_m", Need::kOptional, 1e-3, 1e7).value_or(100.0));
    if (!(camera.far_m > camera.near_m)) {
        reader.add("far_m",
                   fmt::format("{} is not above near_m, which is {}", camera.far_m, camera.near_m));
    }
    if (!position.empty() && !target.empty()) {
        const glm::vec3 view = camera.target_m - camera.position_m;
        if (!(glm::length(view) > 0.0F)) reader.add("target_m", "is where the camera stands");
        if (glm::length(view) > 0.0F && !(glm::length(glm::vec2(view.x, view.z)) > 0.0F)) {
            camera.up = {0.0F, 0.0F, -1.0F};  // straight down or up
        }
    }
    reader.finish();
    return camera;
}

/// Fit for one line of a message.
std::string in_one_line(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < 0x20U) c = '?';
    }
    return text;
}

}  // namespace

const SceneReader::Known& SceneReader::open(const std::string& source, double scale) {
    const auto [entry, fresh] = known_.try_emplace({source, scale});
    if (!fresh) return entry->second;
    try {
        SceneSettings settings;
        settings.scale = scale;
        OpenedScene& opened = entry->second.opened;
        opened = open_scene(source, settings, folder_, catalogue_);
        for (const renderer::Camera& camera : opened.scene->cameras) {
            entry->second.cameras.push_back(camera.name);
        }
        entry->second.files = opened.files;
    } catch (const base::Error& error) {
        entry->second.problem = in_one_line(error.what());
    }
    return entry->second;
}

void SceneReader::read_camera(TableReader& reader, const std::vector<std::string>* names,
                              StudyScene& scene, Problems& problems) {
    const toml::node* value = reader.table().get("camera");
    if (value != nullptr && value->is_table()) {
        (void)reader.table("camera", Need::kRequired);
        scene.settings.camera = read_view(
            *value->as_table(), fmt::format("scene {}, camera", in_quotes(scene.id)), problems);
        scene.camera = kStudyCamera;
    } else if (names != nullptr) {
        scene.camera = reader.choice("camera", Need::kRequired, *names).value_or("");
    } else {
        scene.camera = reader.text("camera", Need::kRequired).value_or("");
    }
}

void SceneReader::read_source(TableReader& reader, StudyScene& scene) {
    const auto source = reader.text("source", Need::kRequired);
    if (!source) return;
    const bool is_file = is_file_source(*source);
    const bool builtin = std::any_of(catalogue_.begin(), catalogue_.end(),
                                     [&](const BuiltinScene& b) { return b.id == *source; });
    if (is_file || builtin) {
        scene.source = *source;
        return;
    }
    std::vector<std::string> sources;
    for (const BuiltinScene& known : catalogue_) sources.push_back(known.id);
    reader.add("source",
               fmt::format("{} is unknown, allowed are {} and files that end in .gltf, "
                           ".glb or .obj{}",
                           in_quotes(*source), listed(sources), did_you_mean(*source, sources)));
}

void SceneReader::read_environment(TableReader& reader, StudyScene& scene) {
    const auto environment = reader.text("environment", Need::kOptional);
    if (!environment) return;
    scene.settings.environment = *environment;
    if (files_ == SceneFiles::kTrusted) return;
    const auto [entry, fresh] = environments_.try_emplace(*environment);
    Known& known = entry->second;
    if (fresh) {
        const std::filesystem::path path = folder_ / *environment;
        std::error_code error;
        try {
            if (!std::filesystem::is_regular_file(path, error)) {
                throw base::bad_input("{}: the file is missing", path.string());
            }
            (void)renderer::load_environment(path);
            known.files = {{path, base::sha256_hex(base::read_file(path))}};
        } catch (const base::Error& wrong) {
            known.problem = in_one_line(wrong.what());
        }
    }
    if (!known.problem.empty()) reader.add("environment", known.problem);
    scene.files.insert(scene.files.end(), known.files.begin(), known.files.end());
}

void SceneReader::read_lights(TableReader& reader, SceneSettings& settings, Problems& problems) {
    const std::string wanted = "an array of tables, each begun with [[scene.light]]";
    const toml::array* list = reader.array("light", Need::kOptional, wanted);
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const toml::table* table = list->get(i)->as_table();
        if (table == nullptr) {
            reader.add("light",
                       fmt::format("holds something that is no table, allowed is {}", wanted));
            continue;
        }
        TableReader light(*table, fmt::format("light {}", i + 1), problems);
        const glm::vec3 colour = read_colour(light, "colour", 1.0).value_or(glm::vec3(1.0F));
        const auto irradiance = light.number("irradiance", Need::kRequired, 0.0, kBrightest);
        const glm::vec3 strength = colour * static_cast<float>(irradiance.value_or(1.0));
        if (table->contains("position_m")) {
            settings.point_lights.push_back(read_point_light(light, strength));
        } else if (const auto direction = read_direction(light, Need::kRequired)) {
            light.allow("position_m");
            settings.lights.push_back({-*direction, strength});
        }
        light.finish();
    }
}

void SceneReader::read_settings(TableReader& reader, SceneSettings& settings, Problems& problems) {
    settings.scale = reader.number("scale", Need::kOptional, 1e-6, 1e6).value_or(1.0);
    const auto factor = [&](const char* key) -> std::optional<float> {
        const auto value = reader.number(key, Need::kOptional, 1e-6, kBrightest);
        if (!value) return std::nullopt;
        return static_cast<float>(*value);
    };
    settings.irradiance_probes = reader.boolean("irradiance_probes", Need::kOptional);
    settings.exposure = factor("exposure");
    settings.white = factor("white");
    const auto curve =
        reader.choice("tone_mapping", Need::kOptional, names_of(renderer::kToneCurves));
    for (const renderer::ToneCurve known : renderer::kToneCurves) {
        if (curve && to_string(known) == *curve) settings.tone_curve = known;
    }
    settings.ambient = read_colour(reader, "ambient", kBrightest);
    read_lights(reader, settings, problems);
}

/// What its file's import says, and what its own camera sees of it.
void SceneReader::add_notes(const Known& known, StudyScene& scene) {
    if (!known.problem.empty()) return;
    scene.notes = known.opened.notes;
    const renderer::Camera* const own = known.opened.scene->find_camera(scene.camera);
    if (!scene.settings.camera && own == nullptr) return;
    const std::string backs =
        note_on_backs(known.opened, {scene.settings.camera ? *scene.settings.camera : *own});
    if (!backs.empty()) scene.notes.push_back(backs);
}

StudyScene SceneReader::read(TableReader& reader, const std::string& id, Problems& problems) {
    StudyScene scene;
    scene.id = id;
    read_source(reader, scene);
    (void)reader.text("licence", Need::kOptional);  // what a package says of it (package/)
    read_settings(reader, scene.settings, problems);
    read_environment(reader, scene);
    const auto builtin = std::find_if(catalogue_.begin(), catalogue_.end(),
                                      [&](const auto& b) { return b.id == scene.source; });
    if (builtin != catalogue_.end()) {
        read_camera(reader, &builtin->cameras, scene, problems);
        if (scene.settings.scale != 1.0) {
            reader.add("scale", "a built-in scene is in metres, allowed is 1");
        }
    } else if (scene.source.empty() || files_ == SceneFiles::kTrusted) {
        // Which cameras there are is not known without the source.
        read_camera(reader, nullptr, scene, problems);
    } else {
        const Known& known = open(scene.source, scene.settings.scale);
        if (!known.problem.empty()) reader.add("source", known.problem);
        read_camera(reader, known.problem.empty() ? &known.cameras : nullptr, scene, problems);
        scene.files.insert(scene.files.begin(), known.files.begin(), known.files.end());
        add_notes(known, scene);
    }
    const auto level = reader.choice("validity", Need::kRequired, names_of(kValidities));
    if (level) scene.validity = *validity_from(*level);
    if (level && builtin != catalogue_.end()) {
        const auto levels = levels_with(builtin->levels, scene.settings);
        if (std::find(levels.begin(), levels.end(), scene.validity) == levels.end()) {
            reader.add("validity",
                       fmt::format("{} has no light for {}, allowed are {}", builtin->id,
                                   in_quotes(*level), listed(names_of(levels))));
        }
    }
    reader.finish();
    return scene;
}

}  // namespace obscura::stimuli
