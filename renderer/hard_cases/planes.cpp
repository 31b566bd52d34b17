// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <glm/gtc/constants.hpp>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

constexpr double kTolerance = 0.005;

void measure_plane(Bench& bench, const Technique& technique, float distance_m, float tilt_deg,
                   double radius_m, const std::string& depth_format) {
    const int size = bench.options().size_px / 2;
    Variant choice = Bench::settings(technique, radius_m);
    choice.depth_format = depth_format;
    const std::string what = fmt::format("a plane at {:g} m, tilt {:g} deg, R {:g} m, depth {}",
                                         distance_m, tilt_deg, radius_m, depth_format);
    const Shot shot = bench.shoot(what, shapes::plane(distance_m, glm::radians(tilt_deg)),
                                  shapes::camera(distance_m), choice, size, size);
    const auto from = [&shot](double expected) {
        return of_accessibility(shot, [&shot, expected](const Values& values) {
            return farthest(shot, values, expected, 0.2);
        });
    };
    const bool facing = tilt_deg == 0.0F;
    bench.expect("A on " + what, 1.0, from(1.0), kTolerance,
                 technique.why_not(facing ? Ideal::kOpenFacing : Ideal::kOpenTilted));
    if (!facing) return;
    bench.expect("closed form of its definition on " + what, technique.facing_wall,
                 from(technique.facing_wall), kTolerance);
}

/// Case 1. The value farthest from what is expected, in the middle of the image. R once grows with
/// the distance, so that it covers the same pixels, and once is half a metre.
void run_planes(Bench& bench, const Technique& technique) {
    for (const float distance_m : {1.0F, 10.0F, 100.0F, 1000.0F, 5000.0F}) {
        for (const float tilt_deg : {0.0F, 45.0F, 60.0F, 80.0F, 85.0F, 89.0F}) {
            for (const char* format : {"r32f", "r16f"}) {
                if (technique.ray_traced && format == std::string("r16f")) continue;
                measure_plane(bench, technique, distance_m, tilt_deg, 0.1 * distance_m, format);
                measure_plane(bench, technique, distance_m, tilt_deg, 0.5, format);
            }
        }
    }
}

}  // namespace

HardCase planes_case() { return {1, "tilted planes near and far", run_planes}; }

}  // namespace obscura::renderer
