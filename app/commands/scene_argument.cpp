// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/scene_argument.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "stimuli/scenes/good_views.h"

namespace obscura::app {
namespace {

constexpr const char* kSceneHelp = "Built-in scene, or a file that ends in .gltf, .glb or .obj";

void add_scale(const Options& app, SceneArgument& argument) {
    app.add("--scale", argument.scale, "Metres of one unit of the file (1e-6 to 1e6)")
        .shows_default();
}

glm::vec3 point_of(const char* option, const std::string& text) {
    glm::vec3 point;
    char rest = '\0';
    if (std::sscanf(text.c_str(), "%f,%f,%f%c", &point.x, &point.y, &point.z, &rest) != 3 ||
        !std::isfinite(point.x + point.y + point.z)) {
        throw base::bad_input("{}: \"{}\" is no point; allowed is X,Y,Z in metres", option, text);
    }
    return point;
}

renderer::Camera described(const CameraArguments& arguments) {
    if (!arguments.names.empty()) {
        throw base::bad_input("--camera names a camera, and --position describes another one");
    }
    if (!(arguments.fov_deg >= 1.0 && arguments.fov_deg <= 170.0)) {
        throw base::bad_input("--fov: {} is not allowed; allowed is 1 to 170 degrees",
                              arguments.fov_deg);
    }
    renderer::Camera camera;
    camera.name.clear();
    camera.position_m = point_of("--position", arguments.position);
    camera.target_m = point_of("--look-at", arguments.look_at);
    if (camera.position_m == camera.target_m) {
        throw base::bad_input("--position and --look-at are the same point");
    }
    camera.vertical_fov_rad =
        static_cast<float>(arguments.fov_deg) * std::numbers::pi_v<float> / 180.0F;
    camera.far_m = 1000.0F;
    return camera;
}

}  // namespace

stimuli::OpenedScene SceneArgument::open() const {
    stimuli::SceneSettings settings;
    settings.scale = scale;
    return stimuli::open_scene(scene, settings);
}

void say_notes(const stimuli::OpenedScene& opened) {
    for (const std::string& note : opened.notes) base::log::warn("{}: {}", opened.title, note);
}

void add_scene(const Options& app, SceneArgument& argument) {
    app.add("SCENE", argument.scene, kSceneHelp).required();
    add_scale(app, argument);
}

void add_scene_option(const Options& app, SceneArgument& argument) {
    app.add("--scene", argument.scene, kSceneHelp).type("SCENE");
    add_scale(app, argument);
}

void add_validity(const Options& app, std::string& validity, const std::string& otherwise) {
    app.add("--validity", validity,
            fmt::format("Level of the scene's light (default: {})", otherwise))
        .type("low|moderate|high");
}

void add_cameras(const Options& app, CameraArguments& arguments) {
    app.add("--camera", arguments.names,
            "Camera by its name (default: the first; the best view of a file without any)")
        .type("NAME")
        .comma_separated();
    app.add("--position", arguments.position, "Place of a camera of your own, in metres")
        .type("X,Y,Z");
    app.add("--look-at", arguments.look_at, "What it looks at, in metres").type("X,Y,Z");
    app.add("--fov", arguments.fov_deg, "Its vertical field of view, in degrees (1 to 170)")
        .shows_default();
}

std::vector<renderer::Camera> cameras_of(const CameraArguments& arguments,
                                         const stimuli::OpenedScene& opened) {
    if (arguments.position.empty() != arguments.look_at.empty()) {
        throw base::bad_input("--position and --look-at go together");
    }
    if (!arguments.position.empty()) return {described(arguments)};
    std::vector<renderer::Camera> cameras;
    for (const std::string& name : arguments.names) cameras.push_back(opened.camera(name));
    if (!cameras.empty()) return cameras;
    return {opened.has_own_camera() ? opened.camera()
                                    : stimuli::find_views(*opened.scene, 1).front().camera};
}

std::string line_of(const renderer::Camera& camera) {
    return camera.name.empty() ? stimuli::study_line(camera)
                               : fmt::format("camera = \"{}\"", camera.name);
}

}  // namespace obscura::app
