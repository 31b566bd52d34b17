// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Case 3. A thin rod and a slab, each more than R before a wall: the wall stays 1.
void run_thin_occluder(Bench& bench, const Technique& technique) {
    constexpr float kRadius_m = 0.3F;
    constexpr float kWall = -6.0F;
    const float front = kWall + 1.5F * kRadius_m;
    const int size = bench.options().size_px;
    for (const bool rod : {true, false}) {
        Scene scene = shapes::empty();
        shapes::add_quad(scene, {-40.0F, -40.0F, kWall}, {80.0F, 0.0F, 0.0F}, {0.0F, 80.0F, 0.0F});
        const float half_width = rod ? 0.04F : 0.8F;
        shapes::add_box(scene, {-half_width, -40.0F, front}, {half_width, 40.0F, front + 0.05F});
        Shot shot = bench.shoot(rod ? "rod" : "slab", scene, shapes::camera(5.0F),
                                Bench::settings(technique, kRadius_m), size, size);
        for (float& depth : shot.depth_m) {
            if (depth < -kWall - 0.1F) depth = 1.0e18F;  // only the wall counts
        }
        const auto from_one = [&shot](const Values& values) {
            return farthest(shot, values, 1.0, 0.0);
        };
        bench.expect(rod ? "A of the wall behind a thin rod" : "A of the wall behind a slab", 1.0,
                     of_accessibility(shot, from_one), 0.005,
                     technique.why_not(Ideal::kOpenFacing));
    }
}

}  // namespace

HardCase thin_occluder_case() { return {3, "thin occluder with a gap above R", run_thin_occluder}; }

}  // namespace obscura::renderer
