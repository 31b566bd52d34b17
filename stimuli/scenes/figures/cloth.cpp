// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/noise.h"
#include "stimuli/scenes/support/parts.h"

namespace obscura::stimuli::figures {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// A fold's profile over its phase: a soft crest and a tighter valley, [-0.5, 0.5].
float crest(float phase) {
    const float part = phase - std::floor(phase);
    const float wave = 0.5F - 0.5F * std::cos(2.0F * kPi * part);
    return wave * (2.0F - wave) * 0.30F + 0.70F * wave - 0.5F;
}

float fold_height(const TubePoint& at, const std::vector<FoldCentre>& centres, std::uint32_t seed) {
    const float warp = gradient_noise(at.position_m * 6.0F, seed);
    const float patchy = gradient_noise(at.position_m * 11.0F, seed + 1);
    // Long soft folds along the tube, then those where it is pressed.
    const glm::vec3 round(1.4F * std::cos(at.angle_rad), 1.4F * std::sin(at.angle_rad),
                          3.5F * at.along_m);
    float height = 0.0010F * patchy + 0.055F * at.radius_m * gradient_noise(round, seed + 2);
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
        const float both = 0.5F * (left + right + std::sqrt(over * over + 0.12F)) - 0.22F;
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
    float high = 0.0065F;
    for (const FoldCentre& centre : centres)
        high = std::max(high, 1.3F * centre.height_m + 0.0060F);
    return {false,
            [centres = std::move(centres), seed](const TubePoint& at) {
                return fold_height(at, centres, seed);
            },
            high};
}

void add_boot(Figure& figure, Sculpture& leather, const Placed& person, const glm::vec3& ankle,
              const glm::vec3& knee, const glm::vec2& toe, float scale, const Shaft& shaft,
              const glm::vec3& colour) {
    const glm::vec2 way = glm::normalize(toe);
    const Placed at{person(ankle.x, 0.0F, ankle.z),
                    axes_from(person.axes * glm::vec3(way.x, 0.0F, way.y), person.axes[1])};
    const auto knot = [&](float x, float y, float z, float w, float h = 0.0F) {
        return at.knot(scale * x, scale * y, scale * z, scale * w, scale * h);
    };
    const auto put = [&](float x, float y, float z) { return at(scale * x, scale * y, scale * z); };
    const StrokeStyle upper{scale * 0.02F, colour, true};
    // Shaft, heel, instep and toe.
    const auto on_shin = [&](float high_m, float behind_m) {
        const glm::vec3 p = ankle + (knee - ankle) * ((high_m - ankle.y) / (knee.y - ankle.y));
        return person(p.x, p.y, p.z - behind_m);
    };
    Sculpture boot;
    boot.add(tube(make_curve({{on_shin(shaft.high_m, 0.012F), shaft.radius_m, 0.0F},
                              {on_shin(0.5F * (shaft.high_m + 0.15F), 0.010F),
                               0.5F * (shaft.radius_m + scale * 0.053F), 0.0F},
                              {on_shin(scale * 0.15F, 0.006F), scale * 0.049F, 0.0F},
                              knot(0, 0.10F, -0.006F, 0.043F),
                              knot(0, 0.06F, -0.012F, 0.038F)},
                             8, at.axes[2]),
                  folded({{0.12F, 0.10F, 0.0F, 0.0026F, 0.036F, 0.5F}}, 77)),
             {0.0F, colour, true});
    boot.add(
        ellipsoid(put(0, 0.050F, -0.026F), scale * glm::vec3(0.0335F, 0.046F, 0.040F), at.axes),
        upper);
    boot.add(tube(make_curve({knot(0, 0.092F, 0.010F, 0.038F, 0.038F),
                              knot(0.002F, 0.066F, 0.070F, 0.038F, 0.036F),
                              knot(0.003F, 0.046F, 0.125F, 0.0400F, 0.031F),
                              knot(0.002F, 0.042F, 0.166F, 0.0350F, 0.026F)},
                             8, at.axes[0])),
             upper);
    boot.carve(half_space(put(0, 0.019F, 0), glm::vec3(0.0F, 1.0F, 0.0F)), {0.002F, colour, false});
    // Toe cap and heel cap are a second layer.
    boot.add(ellipsoid(put(0.002F, 0.036F, 0.166F), scale * glm::vec3(0.0385F, 0.0315F, 0.0345F),
                       at.axes),
             {0.0015F, colour * 0.92F, true});
    // A welt at the top of the shaft.
    boot.add(
        tube(make_curve({{on_shin(shaft.high_m + 0.002F, 0.012F), shaft.radius_m + 0.004F, 0.0F},
                         {on_shin(shaft.high_m - 0.018F, 0.012F), shaft.radius_m + 0.0035F, 0.0F}},
                        3, at.axes[2])),
        {0.002F, colour * 0.85F, true});
    // Sole and heel: outlines in the ground plane, a little wider than the upper.
    const auto half_at = [](float z) {
        constexpr std::array<glm::vec2, 11> kHalf{{{-0.072F, 0.012F},
                                                   {-0.066F, 0.023F},
                                                   {-0.050F, 0.0335F},
                                                   {-0.020F, 0.0360F},
                                                   {0.020F, 0.0345F},
                                                   {0.060F, 0.0385F},
                                                   {0.105F, 0.0460F},
                                                   {0.140F, 0.0465F},
                                                   {0.172F, 0.0400F},
                                                   {0.194F, 0.0260F},
                                                   {0.205F, 0.0100F}}};
        return along_line(kHalf, z);
    };
    renderer::Mesh sole;
    Placement flat;
    flat.transform = glm::mat4(glm::vec4(at.axes[2], 0.0F), glm::vec4(at.axes[0], 0.0F),
                               glm::vec4(at.axes[1], 0.0F), glm::vec4(at.origin_m, 1.0F));
    const auto slab = [&](float from, float to, float low, float high, float grow, float shade) {
        constexpr int kPieces = 14;
        std::vector<glm::vec2> outline;
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i <= kPieces; ++i) {
                const float t = static_cast<float>(side == 0 ? i : kPieces - i) / kPieces;
                // Closer together at the ends, where the outline turns.
                const float z = glm::mix(from, to, 0.5F - 0.5F * std::cos(kPi * t));
                const float half = half_at(z) + grow;
                outline.push_back(scale * glm::vec2(z, side == 0 ? -half : half));
            }
        }
        flat.tint = glm::min(colour * shade, glm::vec3(1.0F));
        append(sole, extrude(outline, scale * low, scale * high), flat);
    };
    slab(-0.072F, 0.205F, 0.0090F, 0.0205F, 0.0F, 0.55F);
    slab(-0.070F, 0.203F, 0.0195F, 0.0245F, -0.0015F, 0.85F);
    slab(-0.072F, 0.008F, 0.0F, 0.0095F, 0.0F, 0.42F);
    slab(0.050F, 0.200F, 0.0F, 0.0095F, -0.001F, 0.42F);
    figure.overlaid.push_back({"sole", Cloth::kLeather, 0.12F, std::move(sole)});
    // Laces cross the instep.
    const glm::vec3 into = at.axes * glm::normalize(glm::vec3(0.0F, -0.75F, -0.66F));
    for (int i = 0; i < 4; ++i) {
        const float t = static_cast<float>(i) / 5.0F;
        const float y = 0.100F + 0.075F * t;
        const float z = 0.105F - 0.050F * t;
        const float half = 0.021F - 0.003F * t;
        figure.overlaid.push_back(
            {"lace", Cloth::kLeather, 0.12F,
             overlay(boot,
                     {.columns = 2,
                      .rows = 8,
                      .thick_m = 0.0032F,
                      .colour = colour * 0.45F,
                      .sunk_m = 0.003F},
                     along_path({put(-half, y, z), put(0.0F, y + 0.003F, z), put(half, y, z)}, into,
                                scale * 0.0065F))});
    }
    leather.add(as_shape(std::move(boot)), {0.0F, colour, true});
}

}  // namespace obscura::stimuli::figures
