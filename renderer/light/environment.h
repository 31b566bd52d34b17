// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace obscura::renderer {

/// Light from infinitely far away: an equirectangular image of radiance, linear Rec. 709.
/// The first row is +Y; column u in [0, 1) looks along (sin(2 pi u), 0, -cos(2 pi u)).
struct Environment {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> radiance;  ///< width * height

    /// The radiance of the texel in that direction (unit length).
    [[nodiscard]] glm::vec3 look_up(const glm::vec3& direction) const;
};

/// The middle of texel (column, row) as a unit vector.
[[nodiscard]] glm::vec3 direction_of_texel(const Environment& environment, int column, int row);

/// A clear or hazy sky over a ground, drawn by formula: deterministic, no file.
struct SkyColours {
    glm::vec3 zenith{0.25F, 0.45F, 0.9F};
    glm::vec3 horizon{0.8F, 0.88F, 1.0F};
    glm::vec3 ground{0.35F, 0.32F, 0.28F};
    glm::vec3 sun_glow{0.6F, 0.5F, 0.35F};    ///< added around `towards_sun`
    glm::vec3 towards_sun{0.3F, 0.8F, 0.5F};  ///< unit length not needed
    float cloud_cover = 0.45F;                ///< 0 clear to 1 overcast
    std::uint64_t seed = 1;                   ///< of the clouds
};
[[nodiscard]] Environment make_sky(const SkyColours& colours, int width = 1024);

/// Reads a Radiance HDR or OpenEXR equirectangular image. Throws bad input naming the file.
[[nodiscard]] Environment load_environment(const std::filesystem::path& file);

/// Nine coefficients of irradiance / pi, so that evaluating them along a normal gives the radiance
/// that a white diffuse surface sends out (Ramamoorthi and Hanrahan 2001, equations 9 to 13).
using IrradianceSh = std::array<glm::vec3, 9>;
/// Real spherical harmonics of order 0 to 2 along a unit vector, in the order of the coefficients
/// (Ramamoorthi and Hanrahan 2001, equation 3).
[[nodiscard]] std::array<double, 9> harmonics(const glm::dvec3& direction);
/// What each coefficient of radiance becomes in irradiance / pi by convolution with the cosine (the
/// same, equation 8: A = pi, 2 pi/3, pi/4; divided by pi).
inline constexpr std::array<double, 9> kCosineLobe = {1.0,  2.0 / 3, 2.0 / 3, 2.0 / 3, 0.25,
                                                      0.25, 0.25,    0.25,    0.25};
[[nodiscard]] IrradianceSh project_irradiance(const Environment& environment);

/// Irradiance / pi on a surface with that unit normal.
[[nodiscard]] glm::vec3 evaluate_irradiance(const IrradianceSh& sh, const glm::vec3& normal);

}  // namespace obscura::renderer
