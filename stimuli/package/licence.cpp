// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/package/licence.h"

#include <toml++/toml.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/base/files.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::stimuli {
namespace {

/// The JSON of a .gltf file, or of the first chunk of a .glb (glTF 2.0, 4.4); whoever opened the
/// scene has checked it.
std::string_view json_of(std::string_view bytes) {
    constexpr std::size_t kHeader = 20;
    if (!bytes.starts_with("glTF")) return bytes;
    std::uint32_t length = 0;
    if (bytes.size() < kHeader) return {};
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    return bytes.substr(kHeader, length);
}

std::string copyright_in(const std::filesystem::path& file) {
    if (file.extension() == ".obj") return {};
    const std::string bytes = base::read_file(file);
    const auto json = nlohmann::json::parse(json_of(bytes), nullptr, false);
    if (!json.is_object() || !json.contains("asset")) return {};
    const nlohmann::json& asset = json["asset"];
    if (!asset.is_object() || !asset.contains("copyright")) return {};
    return asset["copyright"].is_string() ? asset["copyright"].get<std::string>() : "";
}

}  // namespace

std::vector<SceneLicence> licences_of(const Study& study, const std::string& text) {
    const toml::table table = toml::parse(text);
    std::map<std::string, std::string> said;  // by the scene's id
    if (const toml::array* scenes = table["scene"].as_array()) {
        for (const toml::node& node : *scenes) {
            const toml::table& scene = *node.as_table();
            said[scene["id"].value_or(std::string())] = scene["licence"].value_or(std::string());
        }
    }
    std::vector<SceneLicence> licences;
    for (const StudyScene& scene : study.scenes) {
        SceneLicence one{scene.id, scene.source, said[scene.id], "the study"};
        if (one.licence.empty() && !is_file_source(scene.source)) {
            one.licence = "MIT";
            one.said_by = "obscura";
        } else if (one.licence.empty()) {
            one.licence = copyright_in(study.folder / scene.source);
            one.said_by = one.licence.empty() ? "" : "the scene's file";
        }
        licences.push_back(std::move(one));
    }
    return licences;
}

}  // namespace obscura::stimuli
