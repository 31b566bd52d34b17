// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Case 2. A cube 10 R in front of a wall: neither is near enough to occlude the other.
void run_separated_cube(Bench& bench, const Technique& technique) {
    constexpr float kRadius_m = 0.3F;
    Scene scene = shapes::empty();
    const float wall = -6.0F;
    const float back = wall + 10.0F * kRadius_m;
    shapes::add_quad(scene, {-40.0F, -40.0F, wall}, {80.0F, 0.0F, 0.0F}, {0.0F, 80.0F, 0.0F});
    shapes::add_box(scene, {-0.5F, -0.5F, back}, {0.5F, 0.5F, back + 1.0F});
    const int size = bench.options().size_px;
    const Shot shot = bench.shoot("cube and wall", scene, shapes::camera(5.0F),
                                  Bench::settings(technique, kRadius_m), size, size);
    for (const bool of_wall : {true, false}) {
        Shot part = shot;
        for (std::size_t i = 0; i < part.depth_m.size(); ++i) {
            if ((part.depth_m[i] > 5.5F) != of_wall) part.depth_m[i] = 1.0e18F;  // left out
        }
        const auto from_one = [&part](const Values& values) {
            return farthest(part, values, 1.0, 0.0);
        };
        bench.expect(of_wall ? "A of the wall, image border and silhouettes included"
                             : "A of the cube, silhouettes included",
                     1.0, of_accessibility(part, from_one), 0.005,
                     technique.why_not(Ideal::kOpenFacing));
    }
}

}  // namespace

HardCase separated_cube_case() { return {2, "cube far before a wall", run_separated_cube}; }

}  // namespace obscura::renderer
