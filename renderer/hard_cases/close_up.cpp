// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// A cliff is a step: between two distances, each 1.6 times the other, the work more than doubles.
constexpr double kCliff = 2.0;
constexpr int kRepetitions = 9;

struct Place {
    float distance_m;
    Scene scene;
    Camera camera;
    std::vector<double> ms;  ///< one a repetition
};

Scene wall_with_box(float distance_m) {
    Scene scene = shapes::plane(distance_m, 0.0F);
    const float half = 0.2F * distance_m;
    shapes::add_box(scene, {-half, -half, -distance_m}, {half, half, -0.8F * distance_m});
    return scene;
}

std::vector<Place> places() {
    std::vector<Place> list;
    for (float distance_m = 10.0F; distance_m > 0.095F; distance_m /= 1.585F) {
        list.push_back({distance_m, wall_with_box(distance_m), shapes::camera(distance_m), {}});
    }
    return list;
}

/// The growth of the time from one place to the next nearer one, over the repetitions.
struct Growth {
    double least = 0.0;
    double median = 0.0;
    double third_quartile = 0.0;

    void steepest_of(const Growth& other) {
        least = std::max(least, other.least);
        median = std::max(median, other.median);
        third_quartile = std::max(third_quartile, other.third_quartile);
    }
};

Growth growth_between(const Place& farther, const Place& nearer) {
    std::vector<double> factors;
    for (std::size_t run = 0; run < farther.ms.size(); ++run) {
        factors.push_back(nearer.ms[run] / farther.ms[run]);
    }
    std::sort(factors.begin(), factors.end());
    return {factors.front(), factors[factors.size() / 2], factors[factors.size() * 3 / 4]};
}

/// Times of all places in turn, again and again, so that what else the machine does meets each of
/// them. There is a cliff only where every repetition has it, and none where three quarters have
/// none; else it is not decided.
void compare_times(Bench& bench, const Variant& choice, std::vector<Place>& list) {
    const int size = bench.options().size_px;
    for (int run = -1; run < kRepetitions; ++run) {
        for (Place& place : list) {
            const double ms = bench.time_ms(place.scene, place.camera, choice, size, size);
            if (run >= 0) place.ms.push_back(ms);  // the first compiles the shader
        }
    }
    Growth steepest;
    for (std::size_t i = 1; i < list.size(); ++i) {
        steepest.steepest_of(growth_between(list[i - 1], list[i]));
    }
    const bool none = steepest.third_quartile <= kCliff;
    const bool every = steepest.least > kCliff;
    bench.expect_growth(
        "largest growth of the time when 1.6 times nearer", steepest.median, kCliff,
        none    ? Outcome::kHolds
        : every ? Outcome::kFails
                : Outcome::kUndecided,
        fmt::format("median of {} interleaved repetitions, 10 m to 0.1 m with R = 1 m{}",
                    kRepetitions, none || every ? "" : "; their spread is too large to decide"));
}

/// Case 5. R stays 1 m while the camera comes as near as 0.1 m, where R covers far more than the
/// image. The work is counted on the definition, which the shader is held against pixel by pixel:
/// no more look-ups than the descriptor says, and no cliff in them.
void run_close_up(Bench& bench, const Technique& technique) {
    const int size = bench.options().size_px;
    const Variant choice = Bench::settings(technique, 1.0);
    std::vector<Place> list = places();
    int most_reads = 0;
    int before = 0;
    double steepest = 1.0;
    for (const Place& place : list) {
        const std::string what = fmt::format("plane and box at {:.2f} m", place.distance_m);
        const Shot shot = bench.shoot(what, place.scene, place.camera, choice, size, size);
        bench.expect_sound(what, shot);
        if (before > 0)
            steepest = std::max(steepest, static_cast<double>(shot.depth_reads) / before);
        before = shot.depth_reads;
        most_reads = std::max(most_reads, shot.depth_reads);
    }
    if (technique.ray_traced) return;
    if (technique.model) {
        const double declared = fetches_per_pixel(choice);
        bench.expect("look-ups of the depth buffer by a pixel, beyond what its recipe declares",
                     0.0, std::max(0.0, most_reads - declared), 0.0,
                     fmt::format("{} of {} texture reads", most_reads, declared));
        bench.expect("largest growth of the look-ups when 1.6 times nearer", 1.0, steepest,
                     kCliff - 1.0, "10 m to 0.1 m with R = 1 m");
    }
    if (bench.options().timing) compare_times(bench, choice, list);
}

}  // namespace

HardCase close_up_case() { return {5, "close-up", run_close_up}; }

}  // namespace obscura::renderer
