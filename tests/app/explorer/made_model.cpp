// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "tests/app/explorer/made_model.h"

#include <utility>

namespace obscura::app::explorer {

std::shared_ptr<LoadedScene> made_wall() {
    auto scene = std::make_shared<renderer::Scene>();
    renderer::Mesh mesh;
    for (const glm::vec3& at : {glm::vec3(-1.0F, -1.0F, 0.0F), glm::vec3(1.0F, -1.0F, 0.0F),
                                glm::vec3(0.0F, 1.0F, 0.0F)}) {
        renderer::Vertex vertex;
        vertex.position_m = at;
        mesh.vertices.push_back(vertex);
    }
    mesh.indices = {0, 1, 2};
    scene->meshes = {mesh};
    scene->materials = {renderer::Material{}};
    renderer::Camera front;
    front.name = "front";
    renderer::Camera side = front;
    side.name = "side";
    side.position_m = {2.0F, 0.0F, 1.0F};
    scene->cameras = {front, side};
    stimuli::OpenedScene opened;
    opened.id = "wall";
    opened.scene = scene;
    opened.levels = {stimuli::Validity::kLow, stimuli::Validity::kModerate};
    opened.lighting = [](stimuli::Validity) { return renderer::Lighting{}; };
    return std::make_shared<LoadedScene>(std::move(opened));
}

Choices made_choices(const std::string& source) {
    Choices choices;
    choices.scene.id = source;
    choices.scene.source = source;
    choices.width = 64;
    choices.height = 36;
    choices.b = renderer::standard_variant(*renderer::find_technique("blizzard"));
    return choices;
}

Model made_model() {
    Model model(made_choices("wall"));
    model.opened({made_choices("wall"), "", false, made_wall(), ""}, 0.0);
    return model;
}

Shot made_shot(const ShotRequest& request, char side) {
    Shot shot;
    shot.look = request.look;
    shot.quality = request.quality;
    shot.side = side;
    shot.variant = request.choices.side(side);
    shot.width = std::max(1, request.choices.width / request.divisor);
    shot.height = std::max(1, request.choices.height / request.divisor);
    shot.divisor = request.divisor;
    const auto count = static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height);
    shot.rgb.assign(3 * count, 127);
    if (request.buffers) {
        shot.buffers.width = shot.width;
        shot.buffers.height = shot.height;
        for (const char* name : {"Z", "N.X", "N.Y", "N.Z", "ao.Y"}) {
            shot.buffers.channels.push_back({name, std::vector<float>(count, 0.5F)});
        }
    }
    shot.times = {{renderer::Phase::kGeometry, "geometry", 2.0, 0.0}};
    shot.milliseconds = 20.0;
    return shot;
}

void answer(Model& model, const ShotRequest& request, double now_s) {
    for (const char side : request.sides) model.rendered(made_shot(request, side), now_s);
}

}  // namespace obscura::app::explorer
