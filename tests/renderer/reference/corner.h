// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/reference/analytic_scenes.h"
#include "renderer/reference/reference.h"

namespace obscura::tests {

/// A scene of a floor and what stands on it, seen from above and to the right.
struct CornerView {
    renderer::Scene scene = renderer::analytic_scene();
    renderer::Camera camera;

    CornerView() {
        camera.name = "test";
        camera.position_m = {2.0F, 1.5F, 0.0F};
        camera.target_m = {0.5F, 0.0F, 0.0F};
        camera.near_m = 0.01F;
    }
};

/// A floor and a wall, the corner along x = 0.
inline CornerView corner_view() {
    CornerView view;
    renderer::add_floor(view.scene, 0.0, 8.0);
    renderer::add_leaning_wall(view.scene, 1.5707963267948966, 8.0);
    return view;
}

/// The view, its lengths multiplied by `scale` and then moved.
inline CornerView transformed(CornerView view, float scale, const glm::vec3& move) {
    for (renderer::Mesh& mesh : view.scene.meshes) {
        for (renderer::Vertex& vertex : mesh.vertices) {
            vertex.position_m = vertex.position_m * scale + move;
        }
    }
    view.camera.position_m = view.camera.position_m * scale + move;
    view.camera.target_m = view.camera.target_m * scale + move;
    view.camera.near_m *= scale;
    view.camera.far_m *= scale;
    return view;
}

inline renderer::ReferenceOptions rays_within(double radius_m, int rays = 64) {
    renderer::ReferenceOptions options;
    options.radius_m = radius_m;
    options.rays = rays;
    return options;
}

inline double mean_of(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// The greatest difference between two images' accessibility.
inline double greatest_difference(const renderer::ReferenceImage& a,
                                  const renderer::ReferenceImage& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.accessibility.size(); ++i) {
        most = std::max(most, std::abs(static_cast<double>(a.accessibility[i]) -
                                       static_cast<double>(b.accessibility[i])));
    }
    return most;
}

}  // namespace obscura::tests
