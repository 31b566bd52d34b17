// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "renderer/frame/renderer.h"
#include "renderer/scene/scene.h"

namespace obscura::tests {

/// A scene with one plain white material and no light of its own.
inline renderer::Scene empty_scene() {
    renderer::Scene scene;
    scene.name = "test";
    scene.materials.push_back({});
    return scene;
}

/// Adds a parallelogram with corner `origin` and sides u and v; its normal is u x v.
inline void add_quad(renderer::Scene& scene, const glm::vec3& origin, const glm::vec3& u,
                     const glm::vec3& v) {
    renderer::Mesh mesh;
    mesh.name = "quad";
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    for (const auto& [a, b] : {std::pair(0.0F, 0.0F), {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}) {
        renderer::Vertex vertex;
        vertex.position_m = origin + a * u + b * v;
        vertex.normal = normal;
        vertex.tangent = glm::vec4(glm::normalize(u), 1.0F);
        vertex.uv = {a, b};
        mesh.vertices.push_back(vertex);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
}

/// A camera at the origin that looks along -Z.
inline renderer::Camera forward_camera() {
    renderer::Camera camera;
    camera.name = "forward";
    camera.position_m = glm::vec3(0.0F);
    camera.target_m = {0.0F, 0.0F, -1.0F};
    camera.vertical_fov_rad = std::numbers::pi_v<float> / 3.0F;
    camera.near_m = 0.1F;
    camera.far_m = 100.0F;
    return camera;
}

/// A technique as it is by default, without a filter unless one is named.
inline renderer::Variant choice_of(const std::string& name, const std::string& denoise = "none") {
    renderer::Variant choice;
    choice.technique = name;
    choice.samples = renderer::find_technique(name)->samples.standard;
    choice.denoise = denoise;
    return choice;
}

/// A wall at that distance which fills the view and faces the camera.
inline renderer::Scene facing_wall(float distance_m) {
    renderer::Scene scene = empty_scene();
    const float half_m = 4.0F * distance_m;
    add_quad(scene, {-half_m, -half_m, -distance_m}, {2.0F * half_m, 0.0F, 0.0F},
             {0.0F, 2.0F * half_m, 0.0F});
    return scene;
}

/// Six outward faces.
inline void add_box(renderer::Scene& scene, const glm::vec3& low, const glm::vec3& high) {
    const glm::vec3 x(high.x - low.x, 0.0F, 0.0F);
    const glm::vec3 y(0.0F, high.y - low.y, 0.0F);
    const glm::vec3 z(0.0F, 0.0F, high.z - low.z);
    add_quad(scene, low + z, x, y);
    add_quad(scene, low + x, -x, y);
    add_quad(scene, low + x + z, -z, y);
    add_quad(scene, low, z, y);
    add_quad(scene, low + y + z, x, -z);
    add_quad(scene, low, x, z);
}

/// A box on a floor before a hedge with holes, behind a pane.
inline renderer::Scene scene_of_all_kinds() {
    renderer::Scene scene = empty_scene();
    add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    add_box(scene, {-1.0F, -1.0F, -6.0F}, {0.5F, 0.5F, -4.0F});
    scene.textures.push_back(
        {"holes", 2, 2, true, {90, 200, 90, 255, 0, 0, 0, 0, 0, 0, 0, 0, 90, 200, 90, 255}});
    renderer::Material hedge;
    hedge.albedo_texture = 0;
    hedge.coverage = renderer::Coverage::kCutOut;
    hedge.double_sided = true;
    renderer::Material pane;
    pane.coverage = renderer::Coverage::kBlended;
    pane.opacity = 0.95F;
    pane.albedo = glm::vec3(0.2F, 0.3F, 0.6F);
    scene.materials.push_back(hedge);
    scene.materials.push_back(pane);
    add_quad(scene, {-3.0F, -1.0F, -7.0F}, {6.0F, 0.0F, 0.0F}, {0.0F, 3.0F, 0.0F});
    scene.meshes.back().material = 1;
    add_quad(scene, {0.2F, -1.0F, -4.5F}, {1.5F, 0.0F, -1.0F}, {0.0F, 1.2F, 0.0F});
    scene.meshes.back().material = 2;
    return scene;
}

}  // namespace obscura::tests
