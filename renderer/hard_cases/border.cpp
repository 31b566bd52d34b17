// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Root mean square difference over the surfaces of `shot`, at least `margin` from its border, to
/// the middle of `larger`.
double rmse_to_middle(const Shot& shot, const Values& values, const Shot& larger,
                      const Values& larger_values, double margin) {
    const int dx = (larger.width - shot.width) / 2;
    const int dy = (larger.height - shot.height) / 2;
    const int skip = static_cast<int>(margin * shot.width);
    double sum = 0.0;
    int count = 0;
    for (int y = skip; y < shot.height - skip; ++y) {
        for (int x = skip; x < shot.width - skip; ++x) {
            if (!shot.is_surface(shot.at(x, y))) continue;
            const double difference = static_cast<double>(values[shot.at(x, y)]) -
                                      static_cast<double>(larger_values[larger.at(x + dx, y + dy)]);
            sum += difference * difference;
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / count) : 0.0;
}

/// Case 4. An image against the middle of one that is half as large again with the same pixels.
void run_border(Bench& bench, const Technique& technique) {
    const int size = bench.options().size_px / 16 * 16;  // tiles of rotations stay in step
    const Scene scene = shapes::clutter();
    const Camera camera = shapes::camera(5.0F);
    Camera wide = camera;
    wide.vertical_fov_rad = 2.0F * std::atan(1.5F * std::tan(0.5F * camera.vertical_fov_rad));
    const Variant choice = Bench::settings(technique, 0.3);
    const Shot shot = bench.shoot("the image", scene, camera, choice, size, size);
    const Shot larger =
        bench.shoot("the larger one", scene, wide, choice, size * 3 / 2, size * 3 / 2);
    // Sampling noise of the reference: each pixel's rays are scrambled by its place in the image.
    const double tolerance = technique.ray_traced ? 0.02 : 0.005;
    const auto rmse = [&](double margin) {
        return of_both(shot, larger, [&](const Values& values, const Values& larger_values) {
            return rmse_to_middle(shot, values, larger, larger_values, margin);
        });
    };
    bench.expect("RMSE to the middle of a larger image, whole", 0.0, rmse(0.0), tolerance,
                 technique.why_not(Ideal::kWholeScene));
    bench.expect("RMSE to the middle of a larger image, interior", 0.0, rmse(0.15), tolerance,
                 technique.why_not(Ideal::kAnyImage));
}

}  // namespace

HardCase border_case() { return {4, "screen border", run_border}; }

}  // namespace obscura::renderer
