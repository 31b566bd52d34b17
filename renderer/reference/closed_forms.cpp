// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/closed_forms.h"

#include <cmath>
#include <numbers>

#include "renderer/reference/analytic_scenes.h"

namespace obscura::renderer {

double corner_within_radius(double c) {
    if (c >= 1.0) return 1.0;
    const double s = std::sqrt((1.0 - c) * (1.0 + c));
    return 1.0 - (std::acos(c) - c * s) / std::numbers::pi;
}

double corner_with_linear_falloff(double c) {
    if (c >= 1.0) return 1.0;
    if (c <= 0.0) return 0.5;  // the limit: c artanh(s) goes to 0
    const double s = std::sqrt((1.0 - c) * (1.0 + c));
    return 1.0 - (std::acos(c) + c * s - 2.0 * c * std::atanh(s)) / std::numbers::pi;
}

double wedge(double opening_rad) {
    const double s = std::sin(0.5 * opening_rad);
    return s * s;
}

double beside_sphere(double r, double x) { return 1.0 - r * r * r / std::pow(x * x + r * r, 1.5); }

double under_disk(double r, double h) { return h * h / (h * h + r * r); }

double between_plates(double c) { return c >= 1.0 ? 1.0 : c * c; }

double in_pit(double a, double h) { return a * a / (a * a + h * h); }

ClosedFormCheck check_closed_form(const ClosedForm& form, int rays, std::uint64_t seed,
                                  int side_px) {
    ReferenceOptions options = form.options;
    options.rays = rays;
    options.seed = seed;
    const ReferenceImage image =
        ReferenceScene(form.scene).trace(form.camera, side_px, side_px, options);
    const auto count = static_cast<double>(image.accessibility.size());
    double sum = 0.0;
    double squares = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < image.accessibility.size(); ++i) {
        const double value = image.accessibility[i];
        const double error = image.standard_error[i];
        sum += value;
        squares += (value - form.analytic) * (value - form.analytic);
        variance += error * error;
    }
    ClosedFormCheck check;
    check.name = form.name;
    check.analytic = form.analytic;
    check.measured = sum / count;
    check.standard_error = std::sqrt(variance) / count;
    check.pixel_rms = std::sqrt(squares / count);
    check.pixel_error = std::sqrt(variance / count);
    const double off = std::abs(check.measured - form.analytic);
    check.holds = off <= 3.0 * check.standard_error + 2e-5 && check.pixel_rms <= 1e-3;
    return check;
}

Convergence measure_convergence(const std::vector<ClosedForm>& forms, std::uint64_t seed,
                                int side_px) {
    Convergence result;
    std::vector<double> log_rays;
    std::vector<double> log_rms;
    for (int rays = 16; rays <= 4096; rays *= 4) {
        double squares = 0.0;
        int counted = 0;
        for (const ClosedForm& form : forms) {
            if (form.analytic == 0.0 || form.analytic == 1.0) continue;
            const double rms = check_closed_form(form, rays, seed, side_px).pixel_rms;
            squares += rms * rms;
            ++counted;
        }
        result.rays.push_back(rays);
        result.rms.push_back(counted > 0 ? std::sqrt(squares / counted) : 0.0);
        log_rays.push_back(std::log(static_cast<double>(rays)));
        log_rms.push_back(std::log(result.rms.back()));
    }
    const auto count = static_cast<double>(log_rays.size());
    double x = 0.0;
    double y = 0.0;
    for (std::size_t i = 0; i < log_rays.size(); ++i) {
        x += log_rays[i] / count;
        y += log_rms[i] / count;
    }
    double above = 0.0;
    double below = 0.0;
    for (std::size_t i = 0; i < log_rays.size(); ++i) {
        above += (log_rays[i] - x) * (log_rms[i] - y);
        below += (log_rays[i] - x) * (log_rays[i] - x);
    }
    result.order = -above / below;
    result.holds = result.order >= 0.7;
    return result;
}

}  // namespace obscura::renderer
