// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// A cliff is a step: between two distances, each 1.6 times the other, the time more than doubles.
constexpr double kCliff = 2.0;

Scene wall_with_box(float distance_m) {
    Scene scene = shapes::plane(distance_m, 0.0F);
    const float half = 0.2F * distance_m;
    shapes::add_box(scene, {-half, -half, -distance_m}, {half, half, -0.8F * distance_m});
    return scene;
}

/// Case 5. R stays 1 m while the camera comes as near as 0.1 m, where R covers far more than the
/// image.
void run(Bench& bench, const std::string& technique) {
    const int size = bench.options().size_px;
    const TechniqueChoice choice = Bench::settings(technique, 1.0);
    const bool timed = bench.options().timing && technique != kReference;
    double before_ms = 0.0;
    double steepest = 1.0;
    for (float distance_m = 10.0F; distance_m > 0.095F; distance_m /= 1.585F) {
        const Scene scene = wall_with_box(distance_m);
        const Camera camera = shapes::camera(distance_m);
        Shot shot = bench.shoot(scene, camera, choice, size, size);
        bench.expect_sound(technique, fmt::format("plane and box at {:.2f} m", distance_m), shot);
        if (!timed) continue;
        double fastest_ms = shot.accessibility_ms;
        for (int again = 0; again < 6; ++again) {
            shot = bench.shoot(scene, camera, choice, size, size);
            fastest_ms = std::min(fastest_ms, shot.accessibility_ms);
        }
        if (before_ms > 0.0) steepest = std::max(steepest, fastest_ms / before_ms);
        before_ms = fastest_ms;
    }
    if (!timed) return;
    bench.expect(technique, "largest growth of the time when 1.6 times nearer", 1.0, steepest,
                 kCliff - 1.0, "", "fastest of 7 runs, 10 m to 0.1 m with R = 1 m");
}

}  // namespace

HardCase close_up_case() { return {5, "close-up", false, run}; }

}  // namespace obscura::renderer
