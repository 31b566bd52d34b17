// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Case 8. A sphere before empty sky, with the far plane at 100 m and at 1000 km.
void run_background(Bench& bench, const Technique& technique) {
    Scene scene = shapes::empty();
    shapes::add_sphere(scene, {0.0F, 0.0F, -5.0F}, 1.0F);
    const int size = bench.options().size_px;
    Camera camera = shapes::camera(5.0F);
    std::vector<Shot> shots;
    for (const float far_m : {100.0F, 1.0e6F}) {
        camera.far_m = far_m;
        shots.push_back(bench.shoot(fmt::format("far plane at {:g} m", far_m), scene, camera,
                                    Bench::settings(technique, 0.3), size, size));
    }
    double sky = 1.0;
    for (std::size_t i = 0; i < shots[0].depth_m.size(); ++i) {
        for (const Shot& shot : shots) {
            if (!shot.is_surface(i) && shot.accessibility[i] != 1.0F) sky = shot.accessibility[i];
        }
    }
    bench.expect("A of the sky", 1.0, sky, 0.0);
    const auto of_sphere = [&](const Values& values) {
        return farthest(shots[0], values, 1.0, 0.0);
    };
    bench.expect("A of the sphere to its last pixel", 1.0, of_accessibility(shots[0], of_sphere),
                 0.005, technique.why_not(Ideal::kOpenTilted));
    const auto apart = [](const Values& a, const Values& b) {
        double largest = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            largest = std::max(largest, static_cast<double>(std::abs(a[i] - b[i])));
        }
        return largest;
    };
    bench.expect("largest difference between far = 100 m and 1000 km", 0.0,
                 of_both(shots[0], shots[1], apart), 0.005, technique.why_not(Ideal::kAnyFarPlane));
}

}  // namespace

HardCase background_case() { return {8, "background", run_background}; }

}  // namespace obscura::renderer
