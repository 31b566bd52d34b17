// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/accuracy.h"

#include <cmath>

#include "renderer/passes/shared_constants.h"
#include "renderer/scene/camera.h"

namespace obscura::stimuli {
namespace {

constexpr int kPixels = 8000;
constexpr int kRays = 256;
constexpr const char* kRadius = "radius_m";

/// The least odd step that leaves no more than kPixels.
int step_of(int width, int height) {
    const double pixels = static_cast<double>(width) * height;
    int step = 1;
    while (pixels / (step * step) > kPixels) step += 2;
    return step;
}

}  // namespace

std::optional<double> truth_radius_m(const Condition& condition) {
    for (const renderer::Variant* side : {&condition.b, &condition.a}) {
        const auto parameters = side->all_parameters();
        const auto radius = parameters.find(kRadius);
        if (radius != parameters.end() && radius->second > 0.0) return radius->second;
    }
    return std::nullopt;
}

SparseTruth sparse_truth(const renderer::ReferenceScene& scene, const renderer::Camera& camera,
                         int width, int height, double radius_m) {
    const int step = step_of(width, height);
    renderer::ReferenceOptions options;
    options.radius_m = radius_m;
    options.rays = kRays;
    return {width, height, step, radius_m,
            scene.trace(renderer::every_so_many(camera, width, height, step),
                        (width + step - 1) / step, (height + step - 1) / step, options)};
}

std::optional<Accuracy> accuracy_of(const std::vector<float>& accessibility,
                                    const SparseTruth& truth) {
    double squares = 0.0;
    double sum = 0.0;
    int pixels = 0;
    std::size_t i = 0;
    for (int y = 0; y < truth.image.height; ++y) {
        for (int x = 0; x < truth.image.width; ++x, ++i) {
            if (truth.image.depth_m[i] >= kBackgroundDepth_m) continue;
            const double error = static_cast<double>(accessibility.at(truth.whole_pixel(x, y))) -
                                 static_cast<double>(truth.image.accessibility[i]);
            squares += error * error;
            sum += error;
            ++pixels;
        }
    }
    if (pixels == 0) return std::nullopt;
    return Accuracy{std::sqrt(squares / pixels), sum / pixels, truth.radius_m, pixels};
}

}  // namespace obscura::stimuli
