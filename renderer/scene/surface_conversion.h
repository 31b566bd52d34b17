// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace obscura::renderer {

// Between the G-buffer's Blinn-Phong lobe and glTF's metallic-roughness surfaces.

/// Share of light that a surface of that index of refraction reflects straight back (Fresnel at
/// normal incidence; glTF KHR_materials_ior): 1.5 gives 0.04.
[[nodiscard]] inline double reflectance_of_ior(double ior) {
    const double ratio = (ior - 1.0) / (ior + 1.0);
    return ratio * ratio;
}
/// The index of refraction of a reflectance in [0, 1), not below 1.
[[nodiscard]] inline double ior_of_reflectance(double reflectance) {
    const double root = std::sqrt(std::clamp(reflectance, 0.0, 0.9999));
    return (1.0 + root) / (1.0 - root);
}

/// The Blinn-Phong exponent whose lobe is as wide as that of a roughness in [0, 1]:
/// 2 / alpha^2 - 2 with alpha = roughness^2 (Walter et al. 2007, section 5.2; Burley 2012 for
/// alpha), limited to what the G-buffer holds, [1, 255].
[[nodiscard]] inline float blinn_phong_power(double roughness) {
    const double alpha = std::max(roughness * roughness, 1e-4);
    return static_cast<float>(std::clamp(2.0 / (alpha * alpha) - 2.0, 1.0, 255.0));
}
/// The inverse, for an exponent >= 0.
[[nodiscard]] inline double roughness_of_power(double power) {
    return std::pow(2.0 / (power + 2.0), 0.25);
}

/// Luminance of linear Rec. 709.
[[nodiscard]] inline float luminance(const glm::vec3& colour) {
    return glm::dot(colour, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

}  // namespace obscura::renderer
