// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/hard_cases/shapes.h"

#include <cmath>
#include <numbers>

namespace obscura::renderer::shapes {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

Vertex vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& along) {
    Vertex made;
    made.position_m = position;
    made.normal = normal;
    made.tangent = glm::vec4(along, 1.0F);
    return made;
}

}  // namespace

Scene empty() {
    Scene scene;
    scene.name = "hard case";
    Material material;
    material.double_sided = true;
    scene.materials.push_back(material);
    return scene;
}

void add_quad(Scene& scene, const glm::vec3& origin, const glm::vec3& u, const glm::vec3& v) {
    Mesh mesh;
    mesh.name = "quad";
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    for (const glm::vec3& corner : {origin, origin + u, origin + u + v, origin + v}) {
        mesh.vertices.push_back(vertex(corner, normal, glm::normalize(u)));
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
}

void add_box(Scene& scene, const glm::vec3& low, const glm::vec3& high) {
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

void add_sphere(Scene& scene, const glm::vec3& centre, float radius, int rings) {
    Mesh mesh;
    mesh.name = "sphere";
    const int around = 2 * rings;
    for (int ring = 0; ring <= rings; ++ring) {
        const float theta = kPi * static_cast<float>(ring) / static_cast<float>(rings);
        for (int step = 0; step <= around; ++step) {
            const float phi = 2.0F * kPi * static_cast<float>(step) / static_cast<float>(around);
            const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                              -std::sin(theta) * std::sin(phi));
            mesh.vertices.push_back(
                vertex(centre + radius * n, n, {-std::sin(phi), 0.0F, -std::cos(phi)}));
        }
    }
    const auto index = [around](int ring, int step) {
        return static_cast<std::uint32_t>(ring * (around + 1) + step);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < around; ++step) {
            const std::uint32_t corners[4] = {index(ring, step), index(ring + 1, step),
                                              index(ring + 1, step + 1), index(ring, step + 1)};
            // The poles have one triangle, not two.
            if (ring + 1 < rings) {
                mesh.indices.insert(mesh.indices.end(), {corners[0], corners[1], corners[2]});
            }
            if (ring > 0) {
                mesh.indices.insert(mesh.indices.end(), {corners[0], corners[2], corners[3]});
            }
        }
    }
    scene.meshes.push_back(mesh);
}

Scene plane(float distance, float tilt_rad) {
    Scene scene = empty();
    const float half = 400.0F * distance;
    const glm::vec3 up(0.0F, std::cos(tilt_rad), std::sin(tilt_rad));
    // Strips, so that clipping at the camera cuts no triangle that is much larger than the view.
    const glm::vec3 middle(0.0F, 0.0F, -distance);
    add_quad(scene, middle - glm::vec3(half, 0.0F, 0.0F) - half * up, {2.0F * half, 0.0F, 0.0F},
             2.0F * half * up);
    return scene;
}

Camera camera(float distance) {
    Camera camera;
    camera.name = "hard case";
    camera.position_m = glm::vec3(0.0F);
    camera.target_m = {0.0F, 0.0F, -distance};
    camera.vertical_fov_rad = kPi / 3.0F;
    camera.near_m = 0.01F * distance;
    camera.far_m = 100.0F * distance;
    return camera;
}

Scene transformed(Scene scene, float factor, const glm::vec3& shift) {
    for (Mesh& mesh : scene.meshes) {
        for (Vertex& corner : mesh.vertices) {
            corner.position_m = corner.position_m * factor + shift;
        }
    }
    return scene;
}

Camera transformed(Camera camera, float factor, const glm::vec3& shift) {
    camera.position_m = camera.position_m * factor + shift;
    camera.target_m = camera.target_m * factor + shift;
    camera.near_m *= factor;
    camera.far_m *= factor;
    return camera;
}

Scene clutter() {
    Scene scene = empty();
    add_quad(scene, {-20.0F, -1.0F, -8.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 10.0F, 0.0F});
    add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -8.0F});
    for (int i = 0; i < 6; ++i) {
        const float x = static_cast<float>(i) - 3.0F;
        const float z = -4.0F - 0.5F * static_cast<float>(i % 3);
        add_box(scene, {x, -1.0F, z}, {x + 0.625F, 0.25F * static_cast<float>(i % 4), z + 0.5F});
    }
    return scene;
}

}  // namespace obscura::renderer::shapes
