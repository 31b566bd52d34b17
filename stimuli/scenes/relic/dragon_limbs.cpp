// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "stimuli/scenes/relic/dragon.h"

namespace obscura::stimuli::relic {
namespace {

/// A foot's digit: a knuckled finger from `root` that bends at `knuckle` and ends in a claw.
void add_digit(Sculpture& s, const glm::vec3& root, const glm::vec3& knuckle, const glm::vec3& tip,
               const glm::vec3& claw, float thick_m) {
    s.add(round_cone(root, 1.1F * thick_m, knuckle, thick_m), {0.008F, kJade, true});
    s.add(ball(knuckle, 1.12F * thick_m), {0.005F, kJade, true});
    s.add(round_cone(knuckle, thick_m, tip, 0.85F * thick_m), {0.004F, kJade, true});
    // Overlapping shields on the back of the digit, a pad below its tip.
    const glm::vec3 back =
        glm::normalize(2.0F * knuckle - root - tip + glm::vec3(0.0F, 1e-4F, 0.0F));
    for (int i = 0; i < 6; ++i) {
        const float t = (static_cast<float>(i) + 0.5F) / 3.0F;
        const glm::vec3 at =
            t < 1.0F ? glm::mix(root, knuckle, t) : glm::mix(knuckle, tip, t - 1.0F);
        const glm::vec3 along = glm::normalize(t < 1.0F ? knuckle - root : tip - knuckle);
        s.add(ellipsoid(at + back * (0.50F * thick_m),
                        thick_m * glm::vec3(0.80F, 0.72F, 0.62F - 0.02F * static_cast<float>(i)),
                        axes_from(glm::normalize(along - 0.35F * back), back)),
              {0.0015F, kDeep, true});
    }
    s.add(ball(tip - back * (0.45F * thick_m), 0.72F * thick_m), {0.003F, kJade, true});
    const glm::vec3 middle = 0.5F * (tip + claw) + 0.35F * glm::length(claw - tip) *
                                                       glm::normalize(knuckle - root) * 0.3F;
    const Curve nail = make_curve(
        {{tip, 0.92F * thick_m, 0.0F}, {middle, 0.62F * thick_m, 0.0F}, {claw, 0.0014F, 0.0F}}, 5,
        glm::normalize(root - tip));
    s.add(tube(nail), {0.002F, kPale, true});
}

void add_limb(Sculpture& s, const std::vector<Knot>& knots) {
    const Curve bones = make_curve(knots, 6, glm::vec3(0.1F, 0.2F, 1.0F));
    s.add(tube(bones, scales(bones, 9, 0.0240F, false)), {0.022F, kJade, true});
}

/// Flame-shaped locks that fly from an elbow or heel.
void add_flames(Sculpture& s, const glm::vec3& root, const glm::vec3& way, const glm::vec3& across,
                float long_m) {
    for (int i = -1; i <= 1; ++i) {
        const auto t = static_cast<float>(i);
        const glm::vec3 out = glm::normalize(way + across * (0.55F * t));
        const float reach = long_m * (1.0F - 0.2F * std::abs(t));
        s.add(tube(make_curve({{root, 0.013F, 0.009F},
                               {root + out * (0.45F * reach) + across * 0.010F, 0.012F, 0.008F},
                               {root + out * reach - across * 0.012F, 0.0018F, 0.0018F}},
                              6, across)),
              {0.006F, kDeep, true});
    }
}

void add_raised_foreleg(Sculpture& s) {
    const glm::vec3 wrist(-0.335F, 0.545F, 0.315F);
    const glm::vec3 pearl(-0.365F, 0.640F, 0.315F);
    add_limb(s, {{{-0.075F, 0.600F, 0.215F}, 0.066F, 0.0F},
                 {{-0.135F, 0.540F, 0.275F}, 0.054F, 0.0F},
                 {{-0.205F, 0.468F, 0.320F}, 0.040F, 0.0F},
                 {{-0.275F, 0.488F, 0.330F}, 0.037F, 0.0F},
                 {wrist, 0.028F, 0.0F}});
    s.add(ellipsoid(wrist + glm::vec3(-0.010F, 0.020F, 0.0F), {0.034F, 0.022F, 0.034F}),
          {0.015F, kJade, true});
    constexpr float kPearl_m = 0.055F;
    for (int i = 0; i < 4; ++i) {
        const float angle =
            std::numbers::pi_v<float> * (0.25F + 0.5F * static_cast<float>(i)) + 0.3F;
        const glm::vec3 out(std::cos(angle), 0.0F, std::sin(angle));
        const glm::vec3 up(0.0F, 1.0F, 0.0F);
        add_digit(s, wrist + glm::vec3(-0.012F, 0.020F, 0.0F) + out * 0.018F,
                  pearl + out * (kPearl_m + 0.014F) - up * 0.036F,
                  pearl + out * (kPearl_m + 0.008F) + up * 0.006F,
                  pearl + out * (kPearl_m - 0.020F) + up * 0.052F, 0.0125F);
    }
    s.add(ball(pearl, kPearl_m), {0.0F, kPale, true});
    add_flames(s, {-0.215F, 0.455F, 0.335F}, glm::normalize(glm::vec3(0.35F, -0.8F, 0.45F)),
               glm::normalize(glm::vec3(0.9F, 0.4F, 0.0F)), 0.10F);
}

void add_resting_foreleg(Sculpture& s) {
    const glm::vec3 wrist(0.085F, 0.330F, 0.375F);
    add_limb(s, {{{0.020F, 0.530F, 0.235F}, 0.066F, 0.0F},
                 {{0.080F, 0.475F, 0.305F}, 0.054F, 0.0F},
                 {{0.150F, 0.405F, 0.355F}, 0.040F, 0.0F},
                 {{0.125F, 0.362F, 0.380F}, 0.036F, 0.0F},
                 {wrist, 0.029F, 0.0F}});
    s.add(ellipsoid(wrist + glm::vec3(-0.008F, -0.020F, 0.0F), {0.042F, 0.022F, 0.030F}),
          {0.015F, kJade, true});
    for (int i = 0; i < 4; ++i) {
        const float x = 0.034F - 0.0245F * static_cast<float>(i);
        const glm::vec3 root = wrist + glm::vec3(x * 0.8F - 0.010F, -0.022F, 0.010F);
        const float spread = 1.6F * x;
        add_digit(s, root, glm::vec3(root.x + 0.35F * spread, 0.298F, 0.405F),
                  glm::vec3(root.x + 0.75F * spread, 0.248F, 0.412F),
                  glm::vec3(root.x + 0.9F * spread, 0.196F, 0.388F), 0.0135F);
    }
    add_flames(s, {0.165F, 0.395F, 0.350F}, glm::normalize(glm::vec3(0.9F, -0.15F, -0.1F)),
               glm::normalize(glm::vec3(0.2F, 0.9F, 0.0F)), 0.11F);
}

/// A hind leg beside the lower coil, its foot flat on the rock.
void add_hind_leg(Sculpture& s, const Placed& at, float side) {
    const auto p = [&](float x, float y, float z) { return at(side * x, y, z); };
    s.add(ellipsoid(p(0.035F, 0.035F, 0.000F), {0.060F, 0.085F, 0.095F}, at.axes),
          {0.022F, kJade, true});
    add_limb(s, {{p(0.045F, 0.050F, 0.010F), 0.060F, 0.0F},
                 {p(0.080F, 0.030F, 0.085F), 0.044F, 0.0F},
                 {p(0.088F, -0.030F, 0.060F), 0.034F, 0.0F},
                 {p(0.088F, -0.078F, 0.030F), 0.026F, 0.0F},
                 {p(0.090F, -0.104F, 0.070F), 0.024F, 0.0F}});
    for (int i = 0; i < 4; ++i) {
        const float t = static_cast<float>(i) / 3.0F - 0.5F;
        add_digit(s, p(0.090F + 0.030F * t, -0.100F, 0.075F),
                  p(0.090F + 0.070F * t, -0.088F, 0.118F), p(0.090F + 0.100F * t, -0.108F, 0.148F),
                  p(0.090F + 0.112F * t, -0.126F, 0.182F), 0.0135F);
    }
    add_flames(s, p(0.088F, -0.070F, 0.012F),
               at.axes * glm::normalize(glm::vec3(0.3F * side, 0.35F, -0.9F)),
               at.axes * glm::vec3(0.0F, 1.0F, 0.0F), 0.10F);
}

}  // namespace

void add_limbs(Sculpture& sculpture) {
    add_raised_foreleg(sculpture);
    add_resting_foreleg(sculpture);
    const glm::mat3 axes =
        axes_from(glm::normalize(glm::vec3(0.35F, 0.0F, 0.9F)), {0.0F, 1.0F, 0.0F});
    add_hind_leg(sculpture, {glm::vec3(-0.300F, 0.275F, 0.075F), axes}, -1.0F);
}

}  // namespace obscura::stimuli::relic
