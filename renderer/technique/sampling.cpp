// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/sampling.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {

std::vector<glm::vec3> rotation_tile() {
    base::Random random(20100501);
    std::vector<glm::vec3> tile;
    for (int i = 0; i < kTileSize * kTileSize; ++i) {
        // Uniform on the sphere (Archimedes' hat-box theorem).
        const double z = random.uniform(-1.0, 1.0);
        const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double s = std::sqrt(1.0 - z * z);
        tile.emplace_back(s * std::cos(phi), s * std::sin(phi), z);
    }
    return tile;
}

std::vector<glm::vec3> ball_kernel(int count) {
    constexpr double kGolden = 1.0 / std::numbers::phi;
    std::vector<glm::vec3> kernel;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double phi = 2.0 * std::numbers::pi * kGolden * i;
        const double s = std::sqrt(1.0 - z * z);
        // A second irrational rotation keeps length and direction apart.
        const double step = i * std::numbers::sqrt2;
        const double length = 0.5 + 0.5 * (step - std::floor(step));
        kernel.emplace_back(length * s * std::cos(phi), length * s * std::sin(phi), length * z);
    }
    return kernel;
}

NumberTable rotation_table() { return {"rotations", kTileSize, kTileSize, rotation_tile()}; }

std::string points_define(const std::vector<glm::vec3>& points) {
    std::string text = "FOR_EACH_POINT(DO)";
    for (const glm::vec3& point : points) {
        text += fmt::format(" DO(vec3({}, {}, {}))", point.x, point.y, point.z);
    }
    return text;
}

Step accessibility_step(const Variant& variant, const std::string& shader,
                        const std::vector<Read>& reads, int fetches) {
    Step step{"accessibility", shader, reads, Target::kAccessibility.name, {}, fetches};
    step.defines = {"SAMPLES " + std::to_string(variant.samples)};
    if (variant.unclamped) step.defines.emplace_back("UNCLAMPED");
    return step;
}

}  // namespace obscura::renderer
