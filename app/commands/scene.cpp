// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "app/commands/image_size.h"
#include "app/commands/list.h"
#include "app/commands/scene_views.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/export/gltf_export.h"
#include "stimuli/scenes/inspect.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app {
namespace {

struct SceneOptions {
    std::string scene;
    std::string out;
    std::string technique = "blizzard";
    std::string size = "1280x720";
    double scale = 1.0;
};

stimuli::OpenedScene open(const SceneOptions& options) {
    stimuli::SceneSettings settings;
    settings.scale = options.scale;
    return stimuli::open_scene(options.scene, settings);
}

base::ExitCode list_scenes() {
    for (const stimuli::BuiltinScene& scene : stimuli::builtin_scenes()) {
        fmt::print("{}", stimuli::summary_of(stimuli::open_scene(scene.id)));
    }
    return base::ExitCode::kDone;
}

base::ExitCode inspect(const SceneOptions& options) {
    const renderer::Technique* technique = renderer::find_technique(options.technique);
    if (technique == nullptr) {
        std::string known;
        for (const renderer::Technique& one : renderer::techniques()) {
            known += (known.empty() ? "" : ", ") + one.name;
        }
        throw base::bad_input("--technique: there is no technique \"{}\"; there are {}",
                              options.technique, known);
    }
    renderer::Variant choice = renderer::standard_variant(*technique);
    choice.denoise = renderer::standard_denoise(*technique);
    const auto [width, height] = parse_size(options.size);
    fmt::print("{}", stimuli::inspection_of(open(options), choice, width, height));
    return base::ExitCode::kDone;
}

base::ExitCode export_scene(const SceneOptions& options) {
    if (!options.out.ends_with(".glb")) {
        throw base::bad_input("--out: \"{}\" does not end in .glb, which is what is written",
                              options.out);
    }
    const stimuli::OpenedScene scene = open(options);
    for (const std::string& note : scene.notes) base::log::warn("{}: {}", scene.title, note);
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

void add_scene_options(const Options& app, SceneOptions& options) {
    app.add("SCENE", options.scene,
            "Built-in scene by its id, or a file that ends in .gltf, .glb or .obj")
        .required();
    app.add("--scale", options.scale, "Metres of one unit of the file (1e-6 to 1e6)")
        .shows_default();
}

std::function<base::ExitCode()> attach_scene(const Options& app, const Globals&) {
    const auto options = std::make_shared<SceneOptions>();
    const auto chosen = std::make_shared<std::function<base::ExitCode()>>();
    app.require_command();
    app.add_command("list", "The built-in scenes: triangles, cameras, levels, what each needs")
        .when_given([chosen] { *chosen = list_scenes; });

    const Options inspector = app.add_command(
        "inspect", "What a scene holds, what of it is not shown, and what each level allocates");
    add_scene_options(inspector, *options);
    inspector.add("--technique", options->technique, "Technique of the planned image")
        .shows_default();
    inspector.add("--size", options->size, "Of the planned image, WxH in pixels").shows_default();
    inspector.when_given([chosen, options] { *chosen = [options] { return inspect(*options); }; });

    const Options exporter =
        app.add_command("export", "Write a scene with its cameras and lights as binary glTF 2.0");
    add_scene_options(exporter, *options);
    exporter.add("--out", options->out, "File to write, ends in .glb").required();
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
