// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Case 8. A sphere before empty sky, with the far plane at 100 m and at 1000 km.
void run(Bench& bench, const std::string& technique) {
    Scene scene = shapes::empty();
    shapes::add_sphere(scene, {0.0F, 0.0F, -5.0F}, 1.0F);
    const int size = bench.options().size_px;
    Camera camera = shapes::camera(5.0F);
    std::vector<Shot> shots;
    for (const float far_m : {100.0F, 1.0e6F}) {
        camera.far_m = far_m;
        shots.push_back(bench.shoot(scene, camera, Bench::settings(technique, 0.3), size, size));
    }
    double sky = 1.0;
    double apart = 0.0;
    for (std::size_t i = 0; i < shots[0].depth_m.size(); ++i) {
        for (const Shot& shot : shots) {
            if (!shot.is_surface(i) && shot.accessibility[i] != 1.0F) sky = shot.accessibility[i];
        }
        apart = std::max(apart, std::abs(static_cast<double>(shots[0].accessibility[i]) -
                                         static_cast<double>(shots[1].accessibility[i])));
    }
    bench.expect(technique, "A of the sky", 1.0, sky, 0.0);
    bench.expect(technique, "A of the sphere to its last pixel", 1.0,
                 farthest(shots[0], shots[0].accessibility, 1.0, 0.0), 0.005,
                 tilted_by_nature(technique));
    bench.expect(technique, "largest difference between far = 100 m and 1000 km", 0.0, apart, 0.005,
                 technique == "crytek" ? "it weighs occluders by depth / far" : "");
}

}  // namespace

HardCase background_case() { return {8, "background", false, run}; }

}  // namespace obscura::renderer
