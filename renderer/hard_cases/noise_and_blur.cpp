// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "renderer/denoise/denoise.h"
#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"
#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {
namespace {

/// A floor that meets a wall along a line parallel to the image's rows.
Scene straight_corner() {
    Scene scene = shapes::empty();
    shapes::add_quad(scene, {-40.0F, -1.0F, -5.0F}, {80.0F, 0.0F, 0.0F}, {0.0F, 40.0F, 0.0F});
    shapes::add_quad(scene, {-40.0F, -1.0F, 0.0F}, {80.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -5.0F});
    return scene;
}

/// The largest difference, over all rows, between the means of a row's pixels by their place in the
/// tile of rotations; border left out.
double tile_pattern(const Shot& shot, const Values& values) {
    double largest = 0.0;
    const int margin = shot.width / 8 / kTileSize * kTileSize;
    for (int y = margin; y < shot.height - margin; ++y) {
        double mean[kTileSize] = {};
        const int columns = (shot.width - 2 * margin) / kTileSize;
        for (int x = 0; x < columns * kTileSize; ++x) {
            mean[x % kTileSize] += static_cast<double>(values[shot.at(margin + x, y)]) / columns;
        }
        const auto [low, high] = std::minmax_element(std::begin(mean), std::end(mean));
        largest = std::max(largest, *high - *low);
    }
    return largest;
}

/// A near plate over the right half, more than R before a wall that a box darkens just left of the
/// plate's edge.
Scene plate_before_dark_wall() {
    Scene scene = shapes::empty();
    shapes::add_quad(scene, {-40.0F, -40.0F, -5.0F}, {80.0F, 0.0F, 0.0F}, {0.0F, 80.0F, 0.0F});
    shapes::add_quad(scene, {0.0F, -40.0F, -3.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 80.0F, 0.0F});
    shapes::add_box(scene, {-1.2F, -40.0F, -5.0F}, {-0.2F, 40.0F, -4.8F});
    return scene;
}

/// The smallest value on the plate one pixel or more off its edge.
double smallest_on_plate(const Shot& shot, const Values& values) {
    double smallest = 1.0;
    for (int y = shot.height / 8; y < shot.height - shot.height / 8; ++y) {
        for (int x = 1; x < shot.width - shot.width / 8; ++x) {
            const bool plate = shot.depth_m[shot.at(x, y)] < 4.0F;
            const bool next = shot.depth_m[shot.at(x - 1, y)] < 4.0F;
            if (plate && next) {
                smallest = std::min(smallest, static_cast<double>(values[shot.at(x, y)]));
            }
        }
    }
    return smallest;
}

/// A ball on a floor: neighbours that follow a pixel's plane neither wholly nor not at all.
Scene ball_on_floor() {
    Scene scene = shapes::empty();
    shapes::add_quad(scene, {-40.0F, -1.0F, 0.0F}, {80.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    shapes::add_sphere(scene, {0.0F, 0.0F, -4.0F}, 1.0F);
    return scene;
}

/// Case 11, for every filter: one scene after the other, so that the technique's definition is
/// evaluated once for all filters.
void run_noise_and_blur(Bench& bench, const Technique& technique) {
    if (technique.ray_traced) return;  // rays have no tile whose pattern could be left
    const int size = bench.options().size_px;
    const auto with_each = [&](const std::string& what, const Scene& scene, const auto& expect) {
        for (const Denoise& filter : denoise_filters()) {
            if (filter.recipe.steps.empty()) continue;
            Variant choice = Bench::settings(technique, 0.4);
            choice.denoise = filter.name;
            expect(filter, bench.shoot(what, scene, shapes::camera(5.0F), choice, size, size));
        }
    };
    with_each("a straight corner", straight_corner(), [&](const Denoise& filter, const Shot& shot) {
        const auto pattern = [&](const Values& values) { return tile_pattern(shot, values); };
        bench.expect(filter.name + ": 4-pixel pattern left along a straight corner", 0.0,
                     of_denoised(shot, pattern), 0.004);
    });
    with_each("a ball on a floor", ball_on_floor(), [&](const Denoise& filter, const Shot& shot) {
        bench.expect_sound(filter.name + ": a ball on a floor", shot);
    });
    with_each("a plate before a dark wall", plate_before_dark_wall(),
              [&](const Denoise& filter, const Shot& shot) {
                  const auto smallest = [&](const Values& values) {
                      return smallest_on_plate(shot, values);
                  };
                  bench.expect(filter.name + ": smallest A on a plate, 1 pixel off its edge", 1.0,
                               of_denoised(shot, smallest), 0.01,
                               filter.edge_by_nature.empty() ? technique.why_not(Ideal::kOpenFacing)
                                                             : filter.edge_by_nature);
              });
}

}  // namespace

HardCase denoise_case() { return {11, "noise and blur", run_noise_and_blur}; }

}  // namespace obscura::renderer
