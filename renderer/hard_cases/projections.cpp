// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

constexpr float kDistance = 5.0F;
constexpr float kWallAt_m = 0.5F;  ///< of the side wall, to the right of the view axis
/// A at half of R from the wall of a right-angled corner: 1 - (acos c - c s) / pi, c = 0.5.
constexpr double kHalfway = 0.804499;

/// A wall that faces the camera, and another that meets it at a right angle on the right.
Scene corner() {
    Scene scene = shapes::plane(kDistance, 0.0F);
    shapes::add_quad(scene, {kWallAt_m, -100.0F, -kDistance}, {0.0F, 0.0F, 4.0F},
                     {0.0F, 200.0F, 0.0F});
    return scene;
}

/// The mean over the pixels of the facing wall within 0.02 m of the place half of R from the other.
double mean_halfway(const Shot& shot, const Camera& camera) {
    const CameraMatrices matrices = matrices_of(camera, shot.width, shot.height);
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < shot.height; ++y) {
        for (int x = 0; x < shot.width; ++x) {
            const float across =
                2.0F * (static_cast<float>(x) + 0.5F) / static_cast<float>(shot.width) - 1.0F;
            const float at_m = (across * matrices.ray_scale.x + matrices.ray_offset.x) * kDistance;
            const bool on_wall = std::abs(shot.depth_m[shot.at(x, y)] - kDistance) < 0.01F;
            if (!on_wall || std::abs(at_m) > 0.02F + 1.01F * matrices.ray_scale.x * kDistance /
                                                         static_cast<float>(shot.width)) {
                continue;
            }
            sum += static_cast<double>(shot.accessibility[shot.at(x, y)]);
            ++count;
        }
    }
    return count > 0 ? sum / count : std::nan("");
}

/// Case 10. Fields of view of 10, 60 and 120 degrees and an off-centre frustum.
void run_projections(Bench& bench, const Technique& technique) {
    const int size = bench.options().size_px;
    constexpr double kCornerRadius_m = 1.0;
    const Variant choice = Bench::settings(technique, kCornerRadius_m);
    for (const float shift : {0.0F, 0.6F}) {
        for (const float fov_deg : {10.0F, 60.0F, 120.0F}) {
            Camera camera = shapes::camera(kDistance);
            camera.vertical_fov_rad = glm::radians(fov_deg);
            camera.lens_shift = {shift, 0.5F * shift};
            const std::string view = fmt::format("field of view {:g} deg, lens shift {:g}", fov_deg,
                                                 static_cast<double>(shift));
            const Shot wall =
                bench.shoot(view, shapes::plane(kDistance, 0.0F), camera, choice, size, size);
            const auto from = [&wall](double expected) {
                return of_accessibility(wall, [&wall, expected](const Values& values) {
                    return farthest(wall, values, expected, 0.2);
                });
            };
            bench.expect("A of a wall that faces the camera, " + view, 1.0, from(1.0), 0.005,
                         technique.why_not(Ideal::kOpenFacing));
            bench.expect("closed form of its definition on that wall, " + view,
                         technique.facing_wall, from(technique.facing_wall), 0.005);
            if (technique.ray_traced && shift != 0.0F) continue;
            const Shot shot =
                bench.shoot("a corner, " + view, corner(), camera, choice, size, size);
            if (!technique.ray_traced) continue;
            bench.expect("A at half of R from a right-angled corner, " + view, kHalfway,
                         mean_halfway(shot, camera), 0.01,
                         "64 rays a pixel, mean over the pixels there");
        }
    }
}

}  // namespace

HardCase projections_case() { return {10, "projections", run_projections}; }

}  // namespace obscura::renderer
