// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "renderer/base/random.h"
#include "stimuli/scenes/figures/figure.h"

namespace obscura::stimuli::figures {
namespace {

constexpr float kTurnHalf = std::numbers::pi_v<float>;

/// The scalp that hair grows on and lies over.
struct Scalp {
    Placed at;
    float scale;

    /// `turn_rad` from the forehead towards the left ear, `rise_rad` up from the ears' height.
    [[nodiscard]] glm::vec3 own_place(float turn_rad, float rise_rad, float above_m) const {
        const float c = std::cos(rise_rad);
        const glm::vec3 way(c * std::sin(turn_rad), std::sin(rise_rad), c * std::cos(turn_rad));
        return kScalpMiddle + way * (kScalpRadii + above_m);
    }
    [[nodiscard]] glm::vec3 place(float turn_rad, float rise_rad, float above_m) const {
        return out(own_place(turn_rad, rise_rad, above_m));
    }
    /// From metres of a head 0.235 m high to where it stands.
    [[nodiscard]] glm::vec3 out(const glm::vec3& q) const {
        return at(scale * q.x, scale * q.y, scale * q.z);
    }
    [[nodiscard]] glm::vec3 local(float x, float y, float z) const { return out({x, y, z}); }
};

/// How one lock grows from its root.
struct Growth {
    float long_m = 0.03F;
    float wide_m = 0.014F;
    float root_m = 0.001F;     ///< above the scalp at the root
    float lift_m = 0.005F;     ///< above it in the middle
    float end_m = 0.003F;      ///< above it at the end
    float root_shade = 0.55F;  ///< of the colour at the root: other hair is around it
    std::function<glm::vec3(const glm::vec3& q)> comb;  ///< which way it lies at q, any length
};

/// A lock along the scalp, metres of a head 0.235 m high.
void grow(Figure& figure, const Scalp& scalp, float turn, float rise, const Growth& growth,
          const glm::vec3& colour, base::Random& random) {
    constexpr int kSteps = 6;
    Wisp lock;
    lock.strip = static_cast<int>(random.uniform(0.0, 3.0));
    lock.colour = colour;
    lock.root_shade = growth.root_shade;
    lock.width_m = scalp.scale * growth.wide_m;
    lock.inside_m = scalp.out(kScalpMiddle);
    glm::vec3 q = scalp.own_place(turn, rise, 0.0F);
    for (int i = 0; i <= kSteps; ++i) {
        const float t = static_cast<float>(i) / kSteps;
        const glm::vec3 up = glm::normalize((q - kScalpMiddle) / (kScalpRadii * kScalpRadii));
        const float swell = std::sin(kTurnHalf * t);
        const float above = glm::mix(growth.root_m, growth.end_m, t) + growth.lift_m * swell;
        lock.path_m.push_back(scalp.out(q + up * above));
        glm::vec3 way = growth.comb(q);
        way -= up * glm::dot(up, way);
        const float length = glm::length(way);
        if (length < 1e-4F) continue;
        q += way * (growth.long_m / (kSteps * length));
        // Back onto the ellipsoid.
        const glm::vec3 unit = (q - kScalpMiddle) / kScalpRadii;
        q = kScalpMiddle + kScalpRadii * glm::normalize(unit);
    }
    figure.wisps.push_back(std::move(lock));
}

/// Short dense hair close to the skull, below the locks: bands from the crown down.
void add_base(Figure& figure, const Scalp& scalp, const std::function<float(float)>& hairline,
              float above_m, float inset_rad, const glm::vec3& colour) {
    constexpr int kBands = 28;
    for (int i = 0; i < kBands; ++i) {
        const float turn = 2.0F * kTurnHalf * (static_cast<float>(i) + 0.5F) / kBands - kTurnHalf;
        const float low = hairline(std::abs(turn)) + inset_rad;
        Wisp band;
        band.strip = 3;
        band.colour = colour;
        band.root_shade = 1.0F;
        band.width_m = scalp.scale * 0.0225F;
        band.inside_m = scalp.out(kScalpMiddle);
        for (int k = 0; k <= 10; ++k) {
            const float t = static_cast<float>(k) / 10.0F;
            const float rise = glm::mix(0.5F * kTurnHalf - 0.02F, low, t);
            band.path_m.push_back(scalp.place(turn, rise, above_m * (1.0F - 0.6F * t * t)));
        }
        figure.wisps.push_back(std::move(band));
    }
}

float spread(base::Random& random, float size) {
    return static_cast<float>(random.uniform(-size, size));
}

}  // namespace

float along_line(std::span<const glm::vec2> line, float x) {
    std::size_t i = 0;
    while (i + 2 < line.size() && x > line[i + 1].x) ++i;
    const float t = std::clamp((x - line[i].x) / (line[i + 1].x - line[i].x), 0.0F, 1.0F);
    return glm::mix(line[i].y, line[i + 1].y, t * t * (3.0F - 2.0F * t));
}

float short_hairline(float turn_rad) {
    // Forehead, a recess at the temple, the sideburn, over the ear, and down to the nape.
    constexpr std::array<glm::vec2, 9> kLine{{{0.0F, 0.33F},
                                              {0.35F, 0.36F},
                                              {0.62F, 0.43F},
                                              {0.90F, 0.32F},
                                              {1.12F, 0.05F},
                                              {1.32F, -0.36F},
                                              {1.62F, -0.12F},
                                              {2.00F, -0.62F},
                                              {3.20F, -0.98F}}};
    return along_line(kLine, turn_rad);
}

float long_hairline(float turn_rad) {
    constexpr std::array<glm::vec2, 8> kLine{{{0.0F, 0.35F},
                                              {0.35F, 0.36F},
                                              {0.70F, 0.33F},
                                              {1.00F, 0.14F},
                                              {1.28F, -0.24F},
                                              {1.62F, -0.20F},
                                              {2.00F, -0.55F},
                                              {3.20F, -0.90F}}};
    return along_line(kLine, turn_rad);
}

void add_short_hair(Figure& figure, const Placed& at, float scale, const glm::vec3& colour) {
    const Scalp scalp{at, scale};
    base::Random random(11);
    add_base(figure, scalp, short_hairline, 0.0035F, 0.06F, colour * 0.55F);
    // Sides and back: short, down and backwards. From below upwards, each over the one before.
    const auto tone = [&] { return colour * (0.95F + spread(random, 0.22F)); };
    for (int ring = 0; ring < 11; ++ring) {
        for (int i = 0; i < 58; ++i) {
            const float turn = 2.0F * kTurnHalf *
                                   (static_cast<float>(i) + 0.5F * static_cast<float>(ring % 2)) /
                                   58.0F -
                               kTurnHalf + spread(random, 0.05F);
            const float low = short_hairline(std::abs(turn));
            const float rise =
                low + 0.03F + 0.125F * static_cast<float>(ring) + spread(random, 0.05F);
            if (rise > 1.05F) continue;
            // Only the back and the sides: the top is combed otherwise.
            const float side = std::clamp((std::abs(turn) - 0.75F) / 0.30F, 0.0F, 1.0F);
            if (side < 1.0F && rise > 0.55F * side + 0.15F) continue;
            const float high = std::clamp((rise - low) / 1.2F, 0.0F, 1.0F);
            Growth growth;
            growth.long_m = 0.022F + 0.014F * high + spread(random, 0.004F);
            growth.wide_m = 0.013F + spread(random, 0.002F);
            growth.root_m = 0.0008F + 0.0025F * high;
            growth.lift_m = 0.0016F + 0.0032F * high + spread(random, 0.0006F);
            growth.end_m = 0.0012F + 0.0045F * high;
            growth.root_shade = 0.75F;
            const float stray = spread(random, 0.25F);
            growth.comb = [stray](const glm::vec3& q) {
                return glm::vec3(stray, -0.9F, q.z > -0.04F ? -0.8F : -0.1F);
            };
            grow(figure, scalp, turn, rise, growth, tone(), random);
        }
    }
    // The top: from the forehead back and to his left, standing up over the brow.
    for (int row = 0; row < 9; ++row) {
        for (int i = 0; i < 30; ++i) {
            const float side =
                (static_cast<float>(i) + 0.5F * static_cast<float>(row % 2)) / 14.5F - 1.0F;
            const float turn_front = side * 1.15F + spread(random, 0.04F);
            const float low = short_hairline(std::abs(turn_front));
            const float t = static_cast<float>(row) / 8.0F;
            const float rise =
                glm::mix(std::max(low, 0.30F) + 0.01F, 1.42F, t) + spread(random, 0.03F);
            const float front = (1.0F - t) * std::exp(-1.4F * side * side);
            Growth growth;
            growth.long_m = 0.046F - 0.012F * t + spread(random, 0.007F);
            growth.wide_m = 0.015F + spread(random, 0.003F);
            growth.root_m = 0.0005F + 0.004F * t;
            growth.lift_m = 0.0045F + 0.0065F * front + spread(random, 0.0022F);
            growth.end_m = 0.0055F + 0.0075F * front + spread(random, 0.002F);
            growth.root_shade = 0.62F;
            const float stray = spread(random, 0.35F);
            growth.comb = [stray](const glm::vec3& q) {
                const float behind = std::clamp((-q.z - 0.03F) / 0.05F, 0.0F, 1.0F);
                return glm::vec3(0.55F + stray, 0.35F - 1.2F * behind, -0.75F);
            };
            grow(figure, scalp, turn_front, rise, growth, tone(), random);
        }
    }
}

namespace {

void add_tail(Figure& figure, const Scalp& scalp, const glm::vec3& colour, base::Random& random) {
    Sculpture& hair = figure.part("hair", Cloth::kHair, 0.0040F, 0.05F).solid;
    hair.add(ellipsoid(scalp.local(0.0F, 0.060F, -0.110F),
                       scalp.scale * glm::vec3(0.017F, 0.017F, 0.014F), scalp.at.axes),
             {0.0F, colour * 0.35F, true});
    const auto strand = [&](float dx, float dz, const glm::vec3& p, float out_m, float w) {
        return Knot{scalp.local(p.x + out_m * dx, p.y, p.z + out_m * dz), scalp.scale * w, 0.0F};
    };
    const std::array<glm::vec3, 8> kPath{{{0.0F, 0.062F, -0.110F},
                                          {0.006F, 0.064F, -0.142F},
                                          {0.020F, 0.020F, -0.168F},
                                          {0.044F, -0.060F, -0.155F},
                                          {0.072F, -0.140F, -0.112F},
                                          {0.090F, -0.215F, -0.052F},
                                          {0.097F, -0.285F, 0.006F},
                                          {0.094F, -0.345F, 0.040F}}};
    const std::array<float, 8> kOut{0.003F, 0.009F, 0.014F, 0.017F, 0.016F, 0.013F, 0.010F, 0.004F};
    const std::array<float, 8> kThick{0.008F,  0.010F, 0.012F, 0.012F,
                                      0.0105F, 0.009F, 0.006F, 0.0012F};
    for (int i = 0; i < 8; ++i) {
        const float angle = 2.0F * kTurnHalf * static_cast<float>(i) / 7.0F;
        const float r = i == 7 ? 0.0F : 1.0F;
        std::vector<Knot> knots;
        for (std::size_t k = 0; k < kPath.size(); ++k) {
            knots.push_back(
                strand(r * std::cos(angle), r * std::sin(angle),
                       kPath[k] + glm::vec3(spread(random, 0.002F), 0.0F, spread(random, 0.002F)),
                       kOut[k], kThick[k]));
        }
        hair.add(tube(make_curve(knots, 6, scalp.at.axes[0])),
                 {scalp.scale * 0.003F, colour * (0.80F + spread(random, 0.08F)), true});
    }
    // Locks over it, of several lengths.
    for (int i = 0; i < 60; ++i) {
        const float angle = 2.0F * kTurnHalf * (static_cast<float>(i) + 0.5F) / 60.0F * 7.0F;
        const auto first = static_cast<std::size_t>(random.uniform(1.0, 4.0));
        Wisp lock;
        lock.strip = static_cast<int>(random.uniform(0.0, 3.0));
        lock.width_m = scalp.scale * static_cast<float>(random.uniform(0.010, 0.018));
        lock.colour = colour * (0.98F + spread(random, 0.25F));
        lock.root_shade = 0.9F;
        const float wider = 1.0F + spread(random, 0.15F);
        for (std::size_t k = first; k < kPath.size(); ++k) {
            const float out_m = (kOut[k] + kThick[k]) * wider + 0.0010F;
            const glm::vec3 low(
                0.0F, k + 1 == kPath.size() ? -0.035F + spread(random, 0.03F) : 0.0F, 0.0F);
            const auto at = [&](float share) {
                const glm::vec3 p =
                    share == 0.0F ? kPath[k] + low : glm::mix(kPath[k - 1], kPath[k] + low, share);
                return scalp.out(p + out_m * glm::vec3(std::cos(angle), 0.0F, std::sin(angle)));
            };
            if (k > first) lock.path_m.push_back(at(0.5F));
            lock.path_m.push_back(at(0.0F));
        }
        lock.inside_m = scalp.out(kPath[4]);
        figure.wisps.push_back(std::move(lock));
    }
}

/// A lock that has come loose at the temple and hangs beside the cheek.
void hang_lock(Figure& figure, const Scalp& scalp, float side, float turn, float rise, float long_m,
               const glm::vec3& colour, base::Random& random) {
    Wisp lock;
    lock.strip = static_cast<int>(random.uniform(0.0, 3.0));
    lock.width_m = scalp.scale * static_cast<float>(random.uniform(0.006, 0.010));
    lock.colour = colour;
    lock.root_shade = 0.8F;
    lock.inside_m = scalp.local(0.0F, -0.03F, 0.0F);
    const glm::vec3 root = scalp.own_place(side * turn, rise, 0.004F);
    const float bow = static_cast<float>(random.uniform(0.008, 0.015));
    const float wave = spread(random, 0.004F);
    for (int k = 0; k <= 8; ++k) {
        const float t = static_cast<float>(k) / 8.0F;
        lock.path_m.push_back(scalp.out(
            root + glm::vec3(side * (bow * std::sin(2.2F * t) + wave * std::sin(5.0F * t)),
                             -long_m * t, 0.012F * std::sin(2.4F * t) - 0.016F * t * t)));
    }
    figure.wisps.push_back(std::move(lock));
}

}  // namespace

void add_ponytail(Figure& figure, const Placed& at, float scale, const glm::vec3& colour) {
    const Scalp scalp{at, scale};
    base::Random random(23);
    const auto tone = [&] { return colour * (0.98F + spread(random, 0.22F)); };
    add_base(figure, scalp, long_hairline, 0.0045F, 0.05F, colour * 0.6F);
    const glm::vec3 knot(0.0F, 0.062F, -0.108F);
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 46; ++i) {
            const float turn = 2.0F * kTurnHalf *
                                   (static_cast<float>(i) + 0.5F * static_cast<float>(row % 2)) /
                                   46.0F -
                               kTurnHalf + spread(random, 0.05F);
            const float low = long_hairline(std::abs(turn));
            const float rise =
                low + 0.005F + 0.11F * static_cast<float>(row) + spread(random, 0.03F);
            if (rise > 1.45F) continue;
            const glm::vec3 root = scalp.own_place(turn, rise, 0.0F);
            const float away = glm::distance(root, knot);
            if (away < 0.03F) continue;
            const float top = std::clamp((root.y - 0.05F) / 0.05F, 0.0F, 1.0F);
            const float t = std::min(1.0F, static_cast<float>(row) / 5.0F);
            Growth growth;
            growth.long_m = std::min(0.95F * away, 0.085F) * (1.0F + spread(random, 0.12F));
            growth.wide_m = 0.016F + spread(random, 0.003F);
            growth.root_m = 0.0006F + 0.004F * t + 0.003F * top * t;
            growth.lift_m = 0.0030F + 0.0035F * top + spread(random, 0.0012F);
            growth.end_m = 0.0040F + 0.003F * top + spread(random, 0.001F);
            growth.root_shade = row < 2 ? 0.85F : 0.95F;
            const float stray = spread(random, 0.012F);
            growth.comb = [knot, stray](const glm::vec3& q) {
                // Over the crown first, then down to the knot.
                return knot + glm::vec3(stray, 0.022F, 0.0F) - q;
            };
            grow(figure, scalp, turn, rise, growth, tone(), random);
        }
    }
    for (const float side : {-1.0F, 1.0F}) {
        for (int i = 0; i < 7; ++i) {
            hang_lock(figure, scalp, side,
                      0.92F + 0.045F * static_cast<float>(i) + spread(random, 0.03F),
                      0.34F - 0.06F * static_cast<float>(i), 0.070F + spread(random, 0.022F),
                      tone(), random);
        }
    }
    add_tail(figure, scalp, colour, random);
}

}  // namespace obscura::stimuli::figures
