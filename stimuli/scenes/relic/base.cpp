// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "stimuli/scenes/relic/dragon.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::relic {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kDepth = 0.90F;  ///< the plinth is an ellipse: depth over width
constexpr float kWide = 1.15F;   ///< so that the rock ends inside its rim

std::vector<Knot> ellipse(float radius_m, float y_m, float width_m, float height_m) {
    std::vector<Knot> knots;
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
        const float angle = 2.0F * kPi * static_cast<float>(i) / kSteps;
        knots.push_back({{radius_m * std::cos(angle), y_m, radius_m * kDepth * std::sin(angle)},
                         width_m,
                         height_m});
    }
    return knots;
}

/// A lotus petal that leans out from the plinth and curls over at its tip.
void add_petal(Sculpture& s, float angle, float radius_m, float y_m, float size) {
    const glm::vec3 out(std::cos(angle), 0.0F, kDepth * std::sin(angle));
    const glm::vec3 along =
        glm::normalize(glm::vec3(-std::sin(angle), 0.0F, kDepth * std::cos(angle)));
    const glm::vec3 root = out * radius_m + glm::vec3(0.0F, y_m, 0.0F);
    const glm::vec3 up(0.0F, 1.0F, 0.0F);
    const Curve petal = make_curve(
        {{root + up * (-0.01F * size), 0.030F * size, 0.016F * size},
         {root + up * (0.030F * size) + out * (0.034F * size), 0.040F * size, 0.015F * size},
         {root + up * (0.066F * size) + out * (0.044F * size), 0.032F * size, 0.012F * size},
         {root + up * (0.094F * size) + out * (0.064F * size), 0.006F * size, 0.006F * size}},
        4, along);
    s.add(tube(petal), {0.002F, kSandstone, true});
    const glm::vec3 face = out * (0.016F * size);
    for (const float x : {-0.016F, 0.0F, 0.016F}) {
        const glm::vec3 shift = along * (x * size);
        s.carve(tube(make_curve(
                    {{root + up * (0.014F * size) + out * (0.024F * size) + face + shift, 0.0022F,
                      0.0F},
                     {root + up * (0.044F * size) + out * (0.040F * size) + face + shift * 0.9F,
                      0.0026F, 0.0F},
                     {root + up * (0.072F * size) + out * (0.046F * size) + face * 0.85F +
                          shift * 0.35F,
                      0.0016F, 0.0F}},
                    3, out)),
                {0.003F, kSandstone, false});
    }
}

}  // namespace

void add_base(Sculpture& sculpture) {
    const StrokeStyle stone{0.004F, kSandstone, true};
    Sculpture drum;
    drum.add(ellipsoid({0.0F, 0.075F, 0.0F}, {0.40F * kWide, 0.30F, 0.40F * kWide * kDepth}));
    drum.keep(rounded_box({0.0F, 0.060F, 0.0F}, {1.0F, 0.060F, 1.0F}, 0.004F));
    sculpture.add(as_shape(drum), stone);
    sculpture.add(tube(make_curve(ellipse(0.425F * kWide, 0.020F, 0.020F, 0.030F), 2, {0, 1, 0}),
                       {true, nullptr, 0}),
                  stone);
    sculpture.add(tube(make_curve(ellipse(0.405F * kWide, 0.046F, 0.011F, 0.013F), 2, {0, 1, 0})),
                  stone);
    constexpr int kPetals = 25;
    for (int i = 0; i < kPetals; ++i) {
        add_petal(sculpture, 2.0F * kPi * (static_cast<float>(i) + 0.5F) / kPetals, 0.385F * kWide,
                  0.062F, 0.92F);
    }
    for (int i = 0; i < kPetals; ++i) {
        add_petal(sculpture, 2.0F * kPi * static_cast<float>(i) / kPetals, 0.392F * kWide, 0.052F,
                  0.80F);
    }
    // The rock that the dragon lies on.
    Sculpture rock;
    rock.add(ellipsoid({0.0F, 0.10F, 0.0F}, {0.37F, 0.060F, 0.34F}));
    rock.add(ellipsoid({0.04F, 0.14F, -0.02F}, {0.22F, 0.16F, 0.20F}),
             {0.06F, glm::vec3(1.0F), true});
    rock.add(ellipsoid({-0.36F, 0.112F, 0.165F}, {0.065F, 0.030F, 0.070F}),
             {0.03F, glm::vec3(1.0F), true});
    rock.displace({[](const glm::vec3& p) {
                       const glm::vec3 q(p.x, 1.8F * p.y, p.z);
                       return 0.045F * (ridged(q * 8.0F, 5, 2) - 0.7F);
                   },
                   0.035F});
    rock.keep(half_space({0.0F, 0.03F, 0.0F}, {0.0F, -1.0F, 0.0F}));  // within the plinth
    sculpture.add(as_shape(rock), {0.006F, kSandstone, true});
}

}  // namespace obscura::stimuli::relic
