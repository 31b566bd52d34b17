// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Root mean square difference of two images of the same view.
double rmse(const Values& a, const Values& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Case 9. The same scene with a unit of a millimetre, a metre and a kilometre, and moved by 100 km
/// to where floats are 8 mm apart; its corners stay exact there.
void run_units(Bench& bench, const Technique& technique) {
    constexpr float kRadius = 0.3F;
    const int size = bench.options().size_px;
    const Scene scene = shapes::clutter();
    Camera camera = shapes::camera(5.0F);
    camera.target_m = {1.0F, -0.5F, -5.0F};  // turned, so that rounding has its chance
    const Shot metres =
        bench.shoot("metres", scene, camera, Bench::settings(technique, kRadius), size, size);
    const std::pair<float, const char*> units[] = {{1000.0F, "millimetres"},
                                                   {0.001F, "kilometres"}};
    for (const auto& [factor, name] : units) {
        const Shot shot = bench.shoot(
            name, shapes::transformed(scene, factor, glm::vec3(0.0F)),
            shapes::transformed(camera, factor, glm::vec3(0.0F)),
            Bench::settings(technique, static_cast<double>(kRadius) * factor), size, size);
        bench.expect(std::string("RMSE to the scene in metres, in ") + name, 0.0,
                     of_both(metres, shot, rmse), 0.005);
    }
    const glm::vec3 away(1.0e5F, 0.0F, -1.0e5F);
    const Shot moved = bench.shoot("moved by 100 km", shapes::transformed(scene, 1.0F, away),
                                   shapes::transformed(camera, 1.0F, away),
                                   Bench::settings(technique, kRadius), size, size);
    bench.expect("RMSE to the scene at the origin, moved by 100 km", 0.0,
                 of_both(metres, moved, rmse), 0.005);
}

}  // namespace

HardCase units_case() { return {9, "units and places", run_units}; }

}  // namespace obscura::renderer
