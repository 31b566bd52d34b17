// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/light/environment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/images/images.h"

namespace obscura::renderer {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

std::array<double, 9> harmonics(const glm::dvec3& n) {
    return {0.282095,
            0.488603 * n.y,
            0.488603 * n.z,
            0.488603 * n.x,
            1.092548 * n.x * n.y,
            1.092548 * n.y * n.z,
            0.315392 * (3.0 * n.z * n.z - 1.0),
            1.092548 * n.x * n.z,
            0.546274 * (n.x * n.x - n.y * n.y)};
}

glm::vec3 direction_of_texel(const Environment& environment, int column, int row) {
    const double phi = 2.0 * kPi * (column + 0.5) / environment.width;
    const double theta = kPi * (row + 0.5) / environment.height;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

glm::vec3 Environment::look_up(const glm::vec3& direction) const {
    const double u = std::atan2(direction.x, -direction.z) / (2.0 * kPi);
    const double v = std::acos(std::clamp(static_cast<double>(direction.y), -1.0, 1.0)) / kPi;
    const int column = static_cast<int>(std::floor((u - std::floor(u)) * width));
    const int row = std::clamp(static_cast<int>(v * height), 0, height - 1);
    return radiance[static_cast<std::size_t>(row) * width + std::min(column, width - 1)];
}

Environment load_environment(const std::filesystem::path& file) {
    std::string why;
    const std::unique_ptr<images::Reader> image = images::library().open(file, why);
    if (!image) throw base::bad_input("the environment {} cannot be read: {}", file.string(), why);
    // The header promises so much; there may be less memory.
    constexpr std::int64_t kMostTexels = std::int64_t{8192} * 4096;
    if (std::int64_t{image->width} * std::int64_t{image->height} > kMostTexels) {
        throw base::bad_input("the environment {} is {}x{} texels; allowed are {}, as of 8192x4096",
                              file.string(), image->width, image->height, kMostTexels);
    }
    if (image->channels.size() < 3 || image->width < 2 || image->height < 2) {
        throw base::bad_input(
            "the environment {} is {}x{} with {} channels; an equirectangular RGB image is needed",
            file.string(), image->width, image->height, image->channels.size());
    }
    Environment environment;
    environment.name = file.filename().string();
    environment.width = image->width;
    environment.height = image->height;
    environment.radiance.resize(static_cast<std::size_t>(image->width) *
                                static_cast<std::size_t>(image->height));
    if (!image->read_floats(3, &environment.radiance.data()->x, why)) {
        throw base::bad_input("the environment {} cannot be read: {}", file.string(), why);
    }
    for (glm::vec3& value : environment.radiance) {
        for (int i = 0; i < 3; ++i) {
            constexpr float kBrightest = 1e7F;  // the sun outside of a measured sky
            if (!(value[i] >= 0.0F && value[i] <= kBrightest)) {
                throw base::bad_input(
                    "the environment {} holds the radiance {}; allowed is 0 to {}", file.string(),
                    value[i], kBrightest);
            }
        }
    }
    return environment;
}

IrradianceSh project_irradiance(const Environment& environment) {
    std::array<glm::dvec3, 9> sum{};
    for (int row = 0; row < environment.height; ++row) {
        // The exact solid angle of a texel in this row.
        const double solid_angle = 2.0 * kPi / environment.width *
                                   (std::cos(kPi * row / environment.height) -
                                    std::cos(kPi * (row + 1) / environment.height));
        for (int column = 0; column < environment.width; ++column) {
            const glm::dvec3 radiance =
                environment.radiance[static_cast<std::size_t>(row) * environment.width + column];
            const std::array<double, 9> y = harmonics(direction_of_texel(environment, column, row));
            for (int i = 0; i < 9; ++i) sum[i] += radiance * (y[i] * solid_angle);
        }
    }
    IrradianceSh sh;
    for (int i = 0; i < 9; ++i) sh[i] = sum[i] * kCosineLobe[i];
    return sh;
}

glm::vec3 evaluate_irradiance(const IrradianceSh& sh, const glm::vec3& normal) {
    const std::array<double, 9> y = harmonics(normal);
    glm::vec3 sum(0.0F);
    for (int i = 0; i < 9; ++i) sum += sh[i] * static_cast<float>(y[i]);
    return glm::max(sum, glm::vec3(0.0F));
}

}  // namespace obscura::renderer
