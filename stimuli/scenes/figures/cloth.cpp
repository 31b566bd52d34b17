// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::figures {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// A fold's profile over its phase: a soft crest and a tighter valley, [-0.5, 0.5].
float crest(float phase) {
    const float part = phase - std::floor(phase);
    const float wave = 0.5F - 0.5F * std::cos(2.0F * kPi * part);
    return wave * (2.0F - wave) * 0.75F + 0.25F * wave - 0.5F;
}

float fold_height(const TubePoint& at, const std::vector<FoldCentre>& centres, std::uint32_t seed) {
    const float warp = gradient_noise(at.position_m * 6.0F, seed);
    const float patchy = gradient_noise(at.position_m * 11.0F, seed + 1);
    float height = 0.0015F * patchy;
    for (const FoldCentre& centre : centres) {
        const float away = (at.along_m - centre.along_m) / centre.reach_m;
        if (std::abs(away) > 2.0F) continue;
        float turn = at.angle_rad - centre.angle_rad;
        turn -= 2.0F * kPi * std::round(turn / (2.0F * kPi));
        const float side = 0.5F + 0.5F * std::cos(turn);
        // A pressed tube buckles in two families of folds that slant either way and meet on the
        // inner side of the bend; the higher one shows.
        const float step = (at.along_m - centre.along_m) / centre.spacing_m + 0.9F * warp;
        const float slant = 1.7F * std::abs(turn) / kPi;
        const float left = crest(step + slant + 0.35F * turn / kPi);
        const float right = crest(0.83F * step - slant + 0.35F * turn / kPi + 0.4F);
        const float over = left - right;
        const float both = 0.5F * (left + right + std::sqrt(over * over + 0.04F)) - 0.18F;
        // No fold runs all the way round: each fades where the noise says so.
        const float broken = std::clamp(0.70F + 1.1F * patchy + 0.4F * side, 0.0F, 1.15F);
        const float strength =
            std::exp(-away * away) * broken * (centre.evenness + (1.0F - centre.evenness) * side);
        height += 2.0F * centre.height_m * strength * both;
    }
    return height;
}

}  // namespace

TubeStyle folded(std::vector<FoldCentre> centres, std::uint32_t seed) {
    float high = 0.003F;
    for (const FoldCentre& centre : centres) high = std::max(high, 1.3F * centre.height_m + 0.002F);
    return {false,
            [centres = std::move(centres), seed](const TubePoint& at) {
                return fold_height(at, centres, seed);
            },
            high};
}

void add_boot(Sculpture& leather, const Placed& person, const glm::vec3& ankle,
              const glm::vec3& knee, const glm::vec2& toe, float scale, const Shaft& shaft,
              const glm::vec3& colour) {
    const glm::vec2 way = glm::normalize(toe);
    const Placed at{person(ankle.x, 0.0F, ankle.z),
                    axes_from(person.axes * glm::vec3(way.x, 0.0F, way.y), person.axes[1])};
    const auto knot = [&](float x, float y, float z, float w, float h = 0.0F) {
        return at.knot(scale * x, scale * y, scale * z, scale * w, scale * h);
    };
    const StrokeStyle upper{scale * 0.02F, colour, true};
    // Shaft, heel, instep and toe.
    const auto on_shin = [&](float high_m, float behind_m) {
        const glm::vec3 p = ankle + (knee - ankle) * ((high_m - ankle.y) / (knee.y - ankle.y));
        return person(p.x, p.y, p.z - behind_m);
    };
    leather.add(tube(make_curve({{on_shin(shaft.high_m, 0.012F), shaft.radius_m, 0.0F},
                                 {on_shin(0.5F * (shaft.high_m + 0.15F), 0.010F),
                                  0.5F * (shaft.radius_m + scale * 0.054F), 0.0F},
                                 {on_shin(scale * 0.15F, 0.006F), scale * 0.051F, 0.0F},
                                 knot(0, 0.10F, -0.004F, 0.045F),
                                 knot(0, 0.06F, -0.010F, 0.040F)},
                                8, at.axes[2]),
                     folded({{0.12F, 0.10F, 0.0F, 0.004F, 0.030F, 0.6F}}, 77)),
                {0.0F, colour, true});
    leather.add(ellipsoid(at(0, scale * 0.048F, scale * -0.022F),
                          scale * glm::vec3(0.036F, 0.046F, 0.044F), at.axes),
                upper);
    leather.add(tube(make_curve({knot(0, 0.090F, 0.010F, 0.040F, 0.040F),
                                 knot(0.002F, 0.062F, 0.075F, 0.042F, 0.036F),
                                 knot(0.004F, 0.042F, 0.130F, 0.046F, 0.032F),
                                 knot(0.002F, 0.038F, 0.175F, 0.040F, 0.028F)},
                                6, at.axes[0])),
                upper);
    leather.carve(half_space(at(0, scale * 0.016F, 0), glm::vec3(0.0F, 1.0F, 0.0F)),
                  {0.002F, colour, false});
    // Sole and heel, set off from the upper by an edge.
    const glm::vec3 rubber = colour * 0.45F;
    leather.add(tube(make_curve({knot(0, 0.014F, -0.052F, 0.034F, 0.0135F),
                                 knot(0, 0.014F, 0.020F, 0.036F, 0.0135F),
                                 knot(0.003F, 0.014F, 0.120F, 0.048F, 0.0135F),
                                 knot(0.002F, 0.015F, 0.190F, 0.036F, 0.0130F)},
                                6, at.axes[0]),
                     {true, nullptr, 0.0F}),
                {0.001F, rubber, true});
    // Laces cross the instep; a strap runs round the shaft.
    for (int i = 0; i < 5; ++i) {
        const float t = static_cast<float>(i) / 4.0F;
        const float y = 0.088F + 0.090F * t;
        const float z = 0.066F - 0.018F * t;
        leather.add(tube(make_curve({knot(-0.026F, y - 0.008F, z - 0.016F, 0.003F),
                                     knot(0, y, z + 0.002F, 0.003F),
                                     knot(0.026F, y + 0.008F, z - 0.016F, 0.003F)},
                                    4, at.axes[2])),
                    {0.002F, colour * 0.6F, true});
    }
}

}  // namespace obscura::stimuli::figures
