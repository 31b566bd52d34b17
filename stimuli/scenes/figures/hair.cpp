// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::figures {
namespace {

constexpr float kTurnHalf = std::numbers::pi_v<float>;

/// The scalp as an ellipsoid that locks of hair are laid over.
struct Scalp {
    Placed at;
    float scale;

    /// `turn_rad` from the forehead towards the left ear, `height_rad` up from the ears' height.
    [[nodiscard]] glm::vec3 place(float turn_rad, float height_rad, float above_m) const {
        const float c = std::cos(height_rad);
        const glm::vec3 way(c * std::sin(turn_rad), std::sin(height_rad), c * std::cos(turn_rad));
        const glm::vec3 p = glm::vec3(0.0F, 0.034F, -0.012F) +
                            way * (glm::vec3(0.0755F, 0.083F, 0.0965F) + above_m);
        return at(scale * p.x, scale * p.y, scale * p.z);
    }
    [[nodiscard]] glm::vec3 local(float x, float y, float z) const {
        return at(scale * x, scale * y, scale * z);
    }
};

void add_lock(Sculpture& hair, const Scalp& scalp, const std::vector<glm::vec4>& knots,
              float height_share, const glm::vec3& colour) {
    std::vector<Knot> path;
    for (const glm::vec4& k : knots) {
        path.push_back(
            {scalp.place(k.x, k.y, k.z), scalp.scale * k.w * height_share, scalp.scale * k.w});
    }
    Curve curve = make_curve(path, 4, scalp.at.axes[1]);
    const glm::vec3 middle = scalp.local(0.0F, 0.02F, -0.01F);
    for (CurvePoint& point : curve) point.normal = glm::normalize(point.position_m - middle);
    rebuild_frames(curve);
    hair.add(tube(curve), {scalp.scale * 0.0025F, colour, true});
}

/// Fine strands: a relief that runs along directions of constant `field`.
Displacement strands(float height_m, std::function<float(const glm::vec3&)> field) {
    return {[height_m, field = std::move(field)](const glm::vec3& p) {
                const float phase = field(p) + 1.4F * gradient_noise(p * 30.0F, 3);
                return height_m * std::sin(phase);
            },
            height_m};
}

/// Wisps over the hairline of forehead and temples, where `lean_rad` says how they are combed
/// aside.
void add_wisps(Figure& figure, const Sculpture& hair, const Scalp& scalp, float lean_rad,
               const glm::vec3& colour) {
    constexpr int kCards = 110;
    base::Random random(53);
    for (int i = 0; i < kCards; ++i) {
        const float turn = 2.5F * ((static_cast<float>(i) + 0.5F) / kCards - 0.5F);
        // Down over the hair until it ends.
        float edge = 1.2F;
        while (edge > -0.2F && hair.distance(scalp.place(turn, edge, 0.002F)) < 0.0F) edge -= 0.02F;
        Wisp wisp;
        const float length = static_cast<float>(random.uniform(0.16, 0.34));
        const float from = edge - static_cast<float>(random.uniform(0.02, 0.14));
        for (std::size_t k = 0; k < wisp.path_m.size(); ++k) {
            const float t = static_cast<float>(k) / 4.0F;
            const float aside = lean_rad * t * t;
            const glm::vec3 root = scalp.place(turn + aside, from + length * t, 0.003F);
            wisp.outwards = glm::normalize(root - scalp.local(0.0F, 0.034F, -0.012F));
            const float above = hair.distance(root);
            // Out of the skin first, then over the locks.
            wisp.path_m[k] = above < 0.0F ? root + wisp.outwards * (0.0015F - above)
                                          : root + 0.001F * wisp.outwards;
        }
        wisp.width_m = scalp.scale * static_cast<float>(random.uniform(0.007, 0.013));
        wisp.colour = colour * static_cast<float>(random.uniform(0.8, 1.25));
        figure.wisps.push_back(wisp);
    }
}

}  // namespace

void add_short_hair(Figure& figure, const Placed& at, float scale, const glm::vec3& colour) {
    FigurePart& part = figure.part("hair", Cloth::kHair, 0.0046F, 0.05F);
    const Scalp scalp{at, scale};
    Sculpture& hair = part.solid;
    hair.add(ellipsoid(scalp.local(0.0F, 0.036F, -0.014F),
                       scale * glm::vec3(0.0785F, 0.0855F, 0.0985F), at.axes),
             {0.0F, colour, true});
    // Forehead and temples stay free; behind the ears it ends at the nape.
    hair.carve(ellipsoid(scalp.local(0.0F, -0.012F, 0.090F),
                         scale * glm::vec3(0.066F, 0.084F, 0.070F), at.axes),
               {scale * 0.004F, colour, false});
    for (const float x : {-1.0F, 1.0F}) {
        hair.carve(ellipsoid(scalp.local(x * 0.075F, -0.030F, 0.030F),
                             scale * glm::vec3(0.030F, 0.042F, 0.044F), at.axes),
                   {scale * 0.004F, colour, false});
        hair.carve(ellipsoid(scalp.local(x * 0.080F, -0.022F, -0.010F),
                             scale * glm::vec3(0.018F, 0.034F, 0.022F), at.axes),
                   {scale * 0.004F, colour, false});
        hair.add(round_cone(scalp.local(x * 0.0720F, 0.018F, 0.014F), scale * 0.0060F,
                            scalp.local(x * 0.0705F, -0.010F, 0.012F), scale * 0.0028F),
                 {scale * 0.006F, colour, true});
    }
    hair.carve(half_space(scalp.local(0.0F, -0.062F, -0.06F),
                          at.axes * glm::normalize(glm::vec3(0.0F, 1.0F, -0.25F))),
               {scale * 0.006F, colour, false});
    base::Random random(11);
    const auto jitter = [&](float size) { return static_cast<float>(random.uniform(-size, size)); };
    // Top: brushed from the crown forwards and up, a little to the left.
    for (int row = 0; row < 5; ++row) {
        for (int i = 0; i < 9; ++i) {
            const float side = (static_cast<float>(i) - 4.0F) / 4.0F;
            const float turn = side * (0.75F + 0.12F * static_cast<float>(row));
            const float from = 1.35F - 0.16F * static_cast<float>(row) + jitter(0.05F);
            // No lock hangs below the hairline: the edge is that of the cap, and the wisps'.
            const float reach = std::min(0.42F + jitter(0.06F), from - 0.66F - jitter(0.03F));
            const float lift = 0.014F - 0.0016F * static_cast<float>(row) + jitter(0.003F);
            add_lock(hair, scalp,
                     {{turn * 1.25F, from, 0.003F, 0.010F},
                      {turn + 0.06F, from - 0.45F * reach, 0.008F + 0.3F * lift, 0.0120F},
                      {turn + 0.14F + jitter(0.05F), from - reach, 0.004F + lift, 0.0028F}},
                     0.60F, colour * (0.9F + jitter(0.12F)));
        }
    }
    // Sides and back: combed down and backwards.
    for (int ring = 0; ring < 4; ++ring) {
        for (int i = 0; i < 22; ++i) {
            const float turn =
                0.95F + (2.0F * kTurnHalf - 1.9F) *
                            (static_cast<float>(i) + 0.5F * static_cast<float>(ring % 2)) / 21.5F;
            const float back = turn < kTurnHalf ? 1.0F : -1.0F;
            const float from = 1.05F - 0.34F * static_cast<float>(ring) + jitter(0.05F);
            const float near_ear =
                std::abs(std::abs(turn - kTurnHalf) - 0.5F * kTurnHalf) < 0.38F ? 1.0F : 0.0F;
            if (near_ear > 0.0F && ring == 3) continue;
            add_lock(hair, scalp,
                     {{turn - 0.10F * back, from, 0.0025F, 0.0085F},
                      {turn + 0.05F * back, from - 0.20F, 0.0055F, 0.0100F},
                      {turn + 0.16F * back + jitter(0.04F), from - 0.40F, 0.0040F, 0.0022F}},
                     0.50F, colour * (0.88F + jitter(0.12F)));
        }
    }
    add_wisps(figure, hair, scalp, 0.10F, colour);
}

namespace {

float jitter(base::Random& random, float size) {
    return static_cast<float>(random.uniform(-size, size));
}

/// Close to the skull, the face and the neck left free.
void add_cap(Sculpture& hair, const Scalp& scalp, const glm::vec3& colour) {
    hair.add(ellipsoid(scalp.local(0.0F, 0.037F, -0.013F),
                       scalp.scale * glm::vec3(0.0785F, 0.0855F, 0.0985F), scalp.at.axes),
             {0.0F, colour, true});
    hair.add(ellipsoid(scalp.local(0.0F, 0.054F, 0.034F),
                       scalp.scale * glm::vec3(0.068F, 0.050F, 0.058F), scalp.at.axes),
             {scalp.scale * 0.012F, colour, true});
    hair.carve(ellipsoid(scalp.local(0.0F, -0.030F, 0.090F),
                         scalp.scale * glm::vec3(0.0665F, 0.094F, 0.064F), scalp.at.axes),
               {scalp.scale * 0.005F, colour, false});
    for (const float x : {-1.0F, 1.0F}) {
        hair.carve(ellipsoid(scalp.local(x * 0.078F, -0.036F, 0.022F),
                             scalp.scale * glm::vec3(0.026F, 0.044F, 0.046F), scalp.at.axes),
                   {scalp.scale * 0.005F, colour, false});
    }
    hair.carve(half_space(scalp.local(0.0F, -0.052F, -0.06F),
                          scalp.at.axes * glm::normalize(glm::vec3(0.0F, 1.0F, -0.55F))),
               {scalp.scale * 0.006F, colour, false});
}

/// Drawn back from the whole hairline to the knot.
void add_drawn_back(Sculpture& hair, const Scalp& scalp, const glm::vec3& colour,
                    base::Random& random) {
    constexpr int kLocks = 46;
    for (int i = 0; i < kLocks; ++i) {
        const float part_of = (static_cast<float>(i) + 0.5F) / kLocks;
        const float turn = (part_of - 0.5F) * 2.0F * 2.5F;
        const float rise = 0.62F * std::cos(std::min(std::abs(turn) * 0.85F, kTurnHalf)) + 0.02F;
        const float end_turn = turn < 0.0F ? -kTurnHalf + 0.10F : kTurnHalf - 0.10F;
        const float end_rise = 0.32F + 0.10F * std::cos(turn);
        add_lock(hair, scalp,
                 {{turn, rise, 0.0015F, 0.0065F},
                  {turn + 0.33F * (end_turn - turn),
                   rise + 0.45F * (1.25F - rise) * std::exp(-0.6F * turn * turn),
                   0.0045F + jitter(random, 0.0012F), 0.0085F},
                  {turn + 0.70F * (end_turn - turn),
                   end_rise + 0.40F * std::exp(-0.6F * turn * turn), 0.0045F, 0.0075F},
                  {end_turn, end_rise, 0.003F, 0.006F}},
                 0.50F, colour * (0.9F + jitter(random, 0.14F)));
    }
}

void add_tail(Sculpture& hair, const Scalp& scalp, const glm::vec3& colour, base::Random& random) {
    const glm::vec3 knot = scalp.local(0.0F, 0.062F, -0.112F);
    hair.add(ellipsoid(knot, scalp.scale * glm::vec3(0.021F, 0.021F, 0.017F), scalp.at.axes),
             {scalp.scale * 0.006F, colour * 0.35F, true});
    for (int i = 0; i < 9; ++i) {
        const float angle = 2.0F * kTurnHalf * static_cast<float>(i) / 8.0F;
        const float r = i == 8 ? 0.0F : 1.0F;
        const float dx = r * std::cos(angle);
        const float dz = r * std::sin(angle);
        const auto strand = [&](float x, float y, float z, float spread, float w) {
            const float to_side = jitter(random, 0.002F);
            const float to_front = jitter(random, 0.002F);
            return Knot{scalp.local(x + spread * dx + to_side, y, z + spread * dz + to_front),
                        scalp.scale * w, 0.0F};
        };
        hair.add(tube(make_curve({strand(0.0F, 0.064F, -0.112F, 0.006F, 0.010F),
                                  strand(0.006F, 0.068F, -0.150F, 0.012F, 0.012F),
                                  strand(0.020F, 0.020F, -0.180F, 0.019F, 0.014F),
                                  strand(0.046F, -0.060F, -0.165F, 0.022F, 0.014F),
                                  strand(0.078F, -0.140F, -0.120F, 0.020F, 0.013F),
                                  strand(0.098F, -0.215F, -0.055F, 0.016F, 0.011F),
                                  strand(0.104F, -0.285F, 0.010F, 0.012F, 0.008F),
                                  strand(0.098F, -0.345F + 0.03F * dx, 0.050F, 0.006F, 0.0015F)},
                                 6, scalp.at.axes[0])),
                 {scalp.scale * 0.003F, colour * (0.92F + jitter(random, 0.10F)), true});
    }
}

}  // namespace

void add_ponytail(Figure& figure, const Placed& at, float scale, const glm::vec3& colour) {
    FigurePart& part = figure.part("hair", Cloth::kHair, 0.0046F, 0.05F);
    const Scalp scalp{at, scale};
    Sculpture& hair = part.solid;
    base::Random random(23);
    add_cap(hair, scalp, colour);
    add_drawn_back(hair, scalp, colour, random);
    add_tail(hair, scalp, colour, random);
    hair.displace(strands(scale * 0.0006F, [at, scale](const glm::vec3& p) {
        const glm::vec3 q = ((p - at.origin_m) * at.axes) / scale;
        return 900.0F * q.x + 260.0F * q.y;
    }));
}

}  // namespace obscura::stimuli::figures
