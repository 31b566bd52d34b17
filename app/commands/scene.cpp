// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/image_size.h"
#include "app/commands/list.h"
#include "app/commands/scene_argument.h"
#include "app/commands/scene_views.h"
#include "app/commands/variant_arguments.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/export/gltf_export.h"
#include "renderer/light/shadow.h"
#include "stimuli/scenes/inspect.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app {
namespace {

using Json = nlohmann::ordered_json;

struct SceneOptions {
    SceneArgument scene;
    std::string out;
    std::string technique = "blizzard";
    std::string size = "1280x720";
    bool all = false;
    bool json = false;
};

Json json_of_scene(const stimuli::OpenedScene& scene) {
    const renderer::Bounds bounds = renderer::bounds_of(*scene.scene);
    const auto vector = [](const glm::vec3& v) { return std::vector<float>{v.x, v.y, v.z}; };
    Json cameras = Json::array();
    for (const renderer::Camera& camera : scene.scene->cameras) cameras.push_back(camera.name);
    Json levels = Json::array();
    for (const stimuli::Validity level : scene.levels) levels.push_back(to_string(level));
    return {{"id", scene.id},
            {"title", scene.title},
            {"triangles", scene.scene->triangle_count()},
            {"low_m", vector(bounds.low_m)},
            {"high_m", vector(bounds.high_m)},
            {"cameras", cameras},
            {"levels", levels},
            {"notes", stimuli::notes_on(scene)}};
}

base::ExitCode list_scenes(bool json) {
    Json list = Json::array();
    for (const stimuli::BuiltinScene& scene : stimuli::builtin_scenes()) {
        const stimuli::OpenedScene opened = stimuli::open_scene(scene.id);
        if (json) {
            list.push_back(json_of_scene(opened));
        } else {
            fmt::print("{}", stimuli::summary_of(opened));
        }
    }
    if (json) fmt::print("{}\n", list.dump(2));
    return base::ExitCode::kDone;
}

base::ExitCode inspect(const SceneOptions& options) {
    const renderer::Technique& technique = technique_named(options.technique);
    renderer::Variant choice = renderer::standard_variant(technique);
    choice.denoise = renderer::standard_denoise(technique);
    const auto [width, height] = parse_size(options.size);
    const stimuli::OpenedScene scene = options.scene.open();
    if (options.json) {
        fmt::print("{}\n", json_of_scene(scene).dump(2));
    } else if (options.all) {
        fmt::print("{}", stimuli::inspection_of(scene, choice, width, height));
    } else {
        fmt::print("{}All of it, and what an image of it allocates: --all\n",
                   stimuli::overview_of(scene));
    }
    return base::ExitCode::kDone;
}

base::ExitCode export_scene(const SceneOptions& options) {
    if (!options.out.ends_with(".glb")) {
        throw base::bad_input("--out: \"{}\" does not end in .glb, which is what is written",
                              options.out);
    }
    const stimuli::OpenedScene scene = options.scene.open();
    say_notes(scene);
    // The lights of the richest level; glTF holds no environment.
    const renderer::Lighting lighting = scene.lighting(scene.levels.back());
    const std::string bytes = renderer::to_glb(*scene.scene, lighting);
    base::write_file_atomically(options.out, bytes);
    base::log::info("{}: {} bytes, {} triangles, {} cameras, {} lights", options.out, bytes.size(),
                    scene.scene->triangle_count(), scene.scene->cameras.size(),
                    lighting.lights.size() + lighting.point_lights.size());
    std::vector<std::string> left_out;
    if (lighting.environment) {
        left_out.push_back(fmt::format("the environment ({})", lighting.environment->name));
    } else {
        left_out.emplace_back("ambient light");
    }
    if (lighting.tone_mapping) {
        left_out.push_back(fmt::format("tone mapping ({} curve, exposure {:g}, white {:g})",
                                       to_string(lighting.tone_mapping->curve),
                                       lighting.tone_mapping->exposure,
                                       lighting.tone_mapping->white));
    }
    base::log::info("left out, since glTF has no place for it: {}", fmt::join(left_out, ", "));
    if (!scene.builtin) {
        base::log::info("a camera or light that the file lacks is written as Obscura shows it");
    }
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_scene(const Options& app, const Globals&) {
    const auto options = std::make_shared<SceneOptions>();
    const auto chosen = std::make_shared<std::function<base::ExitCode()>>();
    app.require_command();
    const Options lister = app.add_command(
        "list", "List the built-in scenes: triangles, cameras, levels, what each needs");
    lister.add_flag("--json", options->json, "Print JSON");
    lister.when_given(
        [chosen, options] { *chosen = [options] { return list_scenes(options->json); }; });

    const Options inspector = app.add_command(
        "inspect", "Say how large a scene is, its cameras, and what of it is not shown");
    add_scene(inspector, options->scene);
    inspector.add_flag("--all", options->all,
                       "Also materials, textures, lights, files, and what an image of each level "
                       "allocates");
    inspector.add_flag("--json", options->json, "Print JSON");
    inspector.add("--technique", options->technique, "Technique of the planned image")
        .shows_default();
    inspector.add("--size", options->size, "Of the planned image, in pixels")
        .type("WxH")
        .shows_default();
    inspector.when_given([chosen, options] { *chosen = [options] { return inspect(*options); }; });

    const Options exporter =
        app.add_command("export", "Write a scene with its cameras and lights as binary glTF 2.0");
    add_scene(exporter, options->scene);
    exporter.add("--out", options->out, "File to write, ends in .glb").type("FILE").required();
    exporter.when_given(
        [chosen, options] { *chosen = [options] { return export_scene(*options); }; });
    attach_preview(app, chosen);
    attach_cameras(app, chosen);
    return [chosen] { return (*chosen)(); };
}

}  // namespace

Command scene_command() {
    return {"scene", "List, inspect, look at and export scenes, built in or from files",
            attach_scene};
}

}  // namespace obscura::app
