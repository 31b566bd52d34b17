// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/open_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/nearest.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;

/// Of the whole run, since it is its user's permission and no property of a study or scene.
std::vector<fs::path>& allowed_folders() {
    static std::vector<fs::path> folders;
    return folders;
}

std::shared_ptr<const renderer::Environment> standard_sky() {
    renderer::SkyColours sky;
    sky.cloud_cover = 0.5F;
    return std::make_shared<renderer::Environment>(renderer::make_sky(sky));
}

/// The sun of a level `high` for which neither study nor file has a light: where the standard sky
/// glows, about four times as strong as its irradiance.
renderer::DirectionalLight standard_sun() {
    return {glm::normalize(renderer::SkyColours{}.towards_sun), glm::vec3(3.6F, 3.3F, 2.9F)};
}

OpenedScene open_builtin(const BuiltinScene& builtin) {
    OpenedScene opened;
    opened.id = builtin.id;
    opened.title = builtin.title;
    opened.scene = std::make_shared<renderer::Scene>(builtin.build());
    opened.levels = builtin.levels;
    opened.lighting = [own = builtin.lighting, levels = builtin.levels](Validity validity) {
        if (std::find(levels.begin(), levels.end(), validity) != levels.end()) return own(validity);
        // A level that the scene has none for: the study brings all of it.
        renderer::Lighting lighting;
        const auto moderate = std::find(levels.begin(), levels.end(), Validity::kModerate);
        if (validity == Validity::kHigh) {
            if (moderate != levels.end()) lighting = own(Validity::kModerate);
            lighting.normal_mapping = true;
            lighting.tone_mapping.emplace();
        }
        return lighting;
    };
    return opened;
}

OpenedScene open_file(const fs::path& file, const SceneSettings& settings) {
    renderer::ImportedScene imported =
        renderer::import_scene(file, {settings.scale, allowed_folders()});
    OpenedScene opened;
    opened.id = file.stem().string();
    opened.title = file.string();
    opened.builtin = false;
    opened.has_sides = imported.has_sides;
    opened.levels = {kValidities.begin(), kValidities.end()};
    opened.notes = std::move(imported.notes);
    opened.files = std::move(imported.files);
    opened.lighting = [lights = std::move(imported.lights),
                       points = std::move(imported.point_lights)](Validity validity) {
        renderer::Lighting lighting;
        if (validity == Validity::kLow) return lighting;
        lighting.environment = standard_sky();
        if (validity == Validity::kHigh) {
            lighting.lights = lights;
            lighting.point_lights = points;
            if (lights.empty() && points.empty()) lighting.lights.push_back(standard_sun());
            lighting.normal_mapping = true;
            lighting.tone_mapping.emplace();
        }
        return lighting;
    };
    opened.scene = std::make_shared<renderer::Scene>(std::move(imported.scene));
    return opened;
}

void add_settings(OpenedScene& opened, const SceneSettings& settings, const fs::path& folder) {
    if (settings.camera) {
        auto scene = std::make_shared<renderer::Scene>(*opened.scene);
        std::erase_if(scene->cameras, [&](const renderer::Camera& camera) {
            return camera.name == settings.camera->name;
        });
        scene->cameras.insert(scene->cameras.begin(), *settings.camera);
        opened.scene = std::move(scene);
    }
    if (!settings.environment.empty()) {
        const fs::path path = folder / settings.environment;
        std::error_code error;
        if (!fs::is_regular_file(path, error)) {
            throw base::bad_input("the environment {}: the file is missing", path.string());
        }
        opened.files.push_back({path, base::sha256_hex(base::read_file(path))});
    }
    opened.levels = levels_with(opened.levels, settings);
    opened.lighting = [own = opened.lighting, settings, folder](Validity validity) {
        return with_settings(own(validity), validity, settings, folder);
    };
}

}  // namespace

void allow_folders(std::vector<fs::path> folders) { allowed_folders() = std::move(folders); }

bool OpenedScene::has_own_camera() const {
    const std::vector<renderer::Camera>& all = scene->cameras;
    return builtin || all.size() > 1 || all.front().name != renderer::kOverviewCamera;
}

const renderer::Camera& OpenedScene::camera(const std::string& name) const {
    if (name.empty() && !scene->cameras.empty()) return scene->cameras.front();
    if (const renderer::Camera* found = scene->find_camera(name)) return *found;
    std::string known;
    for (const renderer::Camera& camera : scene->cameras) {
        known += (known.empty() ? "" : ", ") + camera.name;
    }
    throw base::bad_input("scene {} has no camera \"{}\"; it has {}", title, name, known);
}

Validity OpenedScene::level(const std::string& name) const {
    std::string known;
    for (const Validity level : levels) {
        if (name.empty() || to_string(level) == name) return level;
        known += (known.empty() ? "" : ", ") + std::string(to_string(level));
    }
    throw base::bad_input("scene {} has no level \"{}\"; it has {}", title, name, known);
}

bool is_file_source(const std::string& source) {
    return source.find('/') != std::string::npos || renderer::is_scene_file(source);
}

OpenedScene open_scene(const std::string& id_or_file, const SceneSettings& settings,
                       const fs::path& folder, const std::vector<BuiltinScene>& catalogue) {
    OpenedScene opened;
    if (is_file_source(id_or_file)) {
        opened = open_file(folder / id_or_file, settings);
    } else {
        const auto builtin =
            std::find_if(catalogue.begin(), catalogue.end(),
                         [&](const BuiltinScene& scene) { return scene.id == id_or_file; });
        if (builtin == catalogue.end()) {
            std::string known;
            std::vector<std::string> ids;
            for (const BuiltinScene& scene : catalogue) {
                known += scene.id + ", ";
                ids.push_back(scene.id);
            }
            throw base::bad_input(
                "there is no scene \"{}\"; there are {}and files that end in .gltf, .glb or .obj{}",
                id_or_file, known, base::did_you_mean(id_or_file, ids));
        }
        if (settings.scale != 1.0) {
            throw base::bad_input("scale: {} is built in and in metres, allowed is 1", id_or_file);
        }
        opened = open_builtin(*builtin);
    }
    add_settings(opened, settings, folder);
    return opened;
}

std::vector<Validity> levels_with(const std::vector<Validity>& own, const SceneSettings& settings) {
    const auto has = [&own](Validity level) {
        return std::find(own.begin(), own.end(), level) != own.end();
    };
    const bool environment = has(Validity::kModerate) || !settings.environment.empty();
    std::vector<Validity> levels;
    if (has(Validity::kLow) || settings.ambient) levels.push_back(Validity::kLow);
    if (environment) levels.push_back(Validity::kModerate);
    if (has(Validity::kHigh) || (environment && settings.has_lights())) {
        levels.push_back(Validity::kHigh);
    }
    return levels;
}

renderer::Lighting with_settings(renderer::Lighting lighting, Validity validity,
                                 const SceneSettings& settings, const fs::path& folder) {
    if (settings.ambient) lighting.ambient = lighting.background = *settings.ambient;
    if (validity != Validity::kLow && !settings.environment.empty()) {
        lighting.environment = std::make_shared<renderer::Environment>(
            renderer::load_environment(folder / settings.environment));
        if (!lighting.tone_mapping) lighting.tone_mapping.emplace();
    }
    if (validity == Validity::kHigh && settings.has_lights()) {
        lighting.lights = settings.lights;
        lighting.point_lights = settings.point_lights;
    }
    if (settings.exposure || settings.white || settings.tone_curve) {
        renderer::ToneMapping mapping = lighting.tone_mapping.value_or(renderer::ToneMapping{});
        mapping.exposure = settings.exposure.value_or(mapping.exposure);
        mapping.white = settings.white.value_or(mapping.white);
        mapping.curve = settings.tone_curve.value_or(mapping.curve);
        lighting.tone_mapping = mapping;
    }
    return lighting;
}

}  // namespace obscura::stimuli
