// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/reference/reference.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

// Accessibility where it can be written down. c = distance / R, in [0, inf); lengths in one unit.

/// A point at c R from the wall of a 90 degree corner, surfaces beyond R ignored; 1/2 at c = 0.
[[nodiscard]] double corner_within_radius(double c);
/// The same where a surface at distance t occludes by 1 - t/R.
[[nodiscard]] double corner_with_linear_falloff(double c);
/// Two half-planes that open by this angle, [0, pi]; no limit of distance.
[[nodiscard]] double wedge(double opening_rad);
/// On a plane, at horizontal distance x from where a sphere of radius r rests on it.
[[nodiscard]] double beside_sphere(double r, double x);
/// Under the middle of a disk of radius r, parallel to the surface, at height h.
[[nodiscard]] double under_disk(double r, double h);
/// Between two parallel planes, a gap of c R apart.
[[nodiscard]] double between_plates(double c);
/// The middle of the floor of a round pit of radius a and depth h.
[[nodiscard]] double in_pit(double a, double h);

/// A scene whose accessibility at what the camera looks at is known. The camera's field of view is
/// so narrow that the value is the same over its image to 1e-5.
struct ClosedForm {
    std::string name;     ///< the scene and its numbers
    double analytic = 1;  ///< accessibility, [0, 1]
    Scene scene;
    Camera camera;
    ReferenceOptions options;  ///< radius and falloff
};

/// Every closed form of the documentation. Surfaces that should have no end reach far enough that
/// what is missing changes the value by less than 1e-5.
[[nodiscard]] std::vector<ClosedForm> closed_forms();

/// The reference held against a closed form, over an image of `pixels` independent estimates.
struct ClosedFormCheck {
    std::string name;
    double analytic = 0;
    double measured = 0;        ///< mean over the image
    double standard_error = 0;  ///< of that mean, from the pixels' own standard errors
    double pixel_rms = 0;       ///< root mean square error of one pixel
    double pixel_error = 0;     ///< root mean square of the standard errors that the pixels report
    /// |measured - analytic| <= 3 standard errors (and 2e-5 for the facets and the ends of the
    /// scene) and pixel_rms <= 1e-3, which 4096 rays reach
    bool holds = false;
};
[[nodiscard]] ClosedFormCheck check_closed_form(const ClosedForm& form, int rays,
                                                std::uint64_t seed, int side_px = 8);

/// How the error of one pixel falls with its rays.
struct Convergence {
    std::vector<int> rays;
    std::vector<double> rms;  ///< over all pixels of all closed forms that have an error at all
    double order = 0;         ///< p of rms ~ rays^-p, least squares on logarithms
    bool holds = false;       ///< order >= 0.7; plain Monte Carlo has 0.5
};
[[nodiscard]] Convergence measure_convergence(const std::vector<ClosedForm>& forms,
                                              std::uint64_t seed, int side_px = 8);

}  // namespace obscura::renderer
