// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Root mean square difference over the surfaces of `shot`, at least `margin` from its border, to
/// the middle of `larger`.
double rmse_to_middle(const Shot& shot, const Shot& larger, double margin) {
    const int dx = (larger.width - shot.width) / 2;
    const int dy = (larger.height - shot.height) / 2;
    const int skip = static_cast<int>(margin * shot.width);
    double sum = 0.0;
    int count = 0;
    for (int y = skip; y < shot.height - skip; ++y) {
        for (int x = skip; x < shot.width - skip; ++x) {
            if (!shot.is_surface(shot.at(x, y))) continue;
            const double difference =
                static_cast<double>(shot.accessibility[shot.at(x, y)]) -
                static_cast<double>(larger.accessibility[larger.at(x + dx, y + dy)]);
            sum += difference * difference;
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / count) : 0.0;
}

/// Case 4. An image against the middle of one that is half as large again with the same pixels.
void run(Bench& bench, const std::string& technique) {
    const int size = bench.options().size_px / 16 * 16;  // tiles of rotations stay in step
    const Scene scene = shapes::clutter();
    const Camera camera = shapes::camera(5.0F);
    Camera wide = camera;
    wide.vertical_fov_rad = 2.0F * std::atan(1.5F * std::tan(0.5F * camera.vertical_fov_rad));
    const TechniqueChoice choice = Bench::settings(technique, 0.3);
    const Shot shot = bench.shoot(scene, camera, choice, size, size);
    const Shot larger = bench.shoot(scene, wide, choice, size * 3 / 2, size * 3 / 2);
    // Sampling noise of the reference: each pixel's rays are scrambled by its place in the image.
    const double tolerance = technique == kReference ? 0.02 : 0.005;
    const std::string texture_space =
        technique == "crytek" ? "its offsets are fractions of the image, not lengths in the scene"
                              : "";
    bench.expect(technique, "RMSE to the middle of a larger image, whole", 0.0,
                 rmse_to_middle(shot, larger, 0.0), tolerance,
                 texture_space.empty() ? border_by_nature(technique) : texture_space);
    bench.expect(technique, "RMSE to the middle of a larger image, interior", 0.0,
                 rmse_to_middle(shot, larger, 0.15), tolerance, texture_space);
}

}  // namespace

HardCase border_case() { return {4, "screen border", false, run}; }

}  // namespace obscura::renderer
