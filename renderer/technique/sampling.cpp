// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/sampling.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/progressive.h"

namespace obscura::renderer {

namespace {

/// Of two numbers in [0, 1], uniform on the sphere (Archimedes' hat-box theorem).
glm::vec3 on_sphere(double u, double v) {
    const double z = 2.0 * u - 1.0;
    const double phi = 2.0 * std::numbers::pi * v;
    const double s = std::sqrt(1.0 - z * z);
    return {s * std::cos(phi), s * std::sin(phi), z};
}

}  // namespace

Tile<glm::vec3> rotation_tile(std::string_view noise) {
    if (noise != "tile4x4") {
        Tile<glm::vec3> tile{noise_tile(noise).size, {}};
        for (const glm::dvec2& value : noise_tile(noise)) {
            tile.values.push_back(on_sphere(value.x, value.y));
        }
        return tile;
    }
    base::Random random(20100501);
    Tile<glm::vec3> tile{kTileSize, {}};
    for (int i = 0; i < kTileSize * kTileSize; ++i) {
        const double z = random.uniform(-1.0, 1.0);
        const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double s = std::sqrt(1.0 - z * z);
        tile.values.emplace_back(s * std::cos(phi), s * std::sin(phi), z);
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

NumberTable rotation_table(std::string_view noise) {
    const Tile<glm::vec3> tile = rotation_tile(noise);
    return {"rotations", tile.size, tile.size, tile.values};
}

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
    step.depth_beside = true;  // passes/accessibility.glsl does
    const int tile = variant.noise == "tile4x4" ? kTileSize : noise_tile(variant.noise).size;
    step.defines = {"SAMPLES " + std::to_string(samples_of_frame(variant)),
                    "NOISE_SIZE " + std::to_string(tile)};
    if (variant.position == "stored") {
        step.defines.emplace_back("POSITION_STORED");
        ++step.fetches;
    }
    if (variant.position == "inverse-projection") step.defines.emplace_back("POSITION_INVERSE");
    if (variant.unclamped) step.defines.emplace_back("UNCLAMPED");
    return step;
}

}  // namespace obscura::renderer
