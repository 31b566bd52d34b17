// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "stimuli/scenes/relic/dragon.h"

namespace obscura::stimuli::relic {
namespace {

constexpr std::array kSides{-1.0F, 1.0F};

/// The lower jaw's own place: hinged below the skull and swung open.
Placed jaw_place(const Placed& head) {
    constexpr float kOpen_rad = 0.60F;
    const float c = std::cos(kOpen_rad);
    const float s = std::sin(kOpen_rad);
    const glm::mat3 swing(glm::vec3(1, 0, 0), glm::vec3(0, c, s), glm::vec3(0, -s, c));
    return {head(0.0F, -0.022F, 0.0F), head.axes * swing};
}

void add_skull(Sculpture& s, const Placed& at) {
    const auto blob = [&](float x, float y, float z, const glm::vec3& radii, float blend) {
        s.add(ellipsoid(at(x, y, z), radii, at.axes), {blend, kJade, true});
    };
    blob(0.0F, 0.012F, -0.015F, {0.060F, 0.056F, 0.080F}, 0.0F);
    s.add(tube(make_curve(
              {at.knot(0, 0.022F, 0.02F, 0.052F, 0.040F), at.knot(0, 0.010F, 0.10F, 0.039F, 0.028F),
               at.knot(0, 0.012F, 0.165F, 0.038F, 0.025F),
               at.knot(0, 0.016F, 0.192F, 0.034F, 0.024F)},
              6, at.axes[0])),
          {0.025F, kJade, true});
    blob(0.0F, 0.028F, 0.198F, {0.032F, 0.022F, 0.024F}, 0.018F);
    for (const float x : kSides) {
        blob(x * 0.050F, -0.006F, 0.010F, {0.028F, 0.034F, 0.045F}, 0.02F);
        blob(x * 0.024F, 0.036F, 0.196F, {0.017F, 0.016F, 0.021F}, 0.010F);
        // The upper lip, curling out over the teeth.
        s.add(tube(make_curve({at.knot(x * 0.054F, -0.014F, 0.015F, 0.010F),
                               at.knot(x * 0.046F, -0.010F, 0.070F, 0.011F),
                               at.knot(x * 0.041F, -0.016F, 0.125F, 0.010F),
                               at.knot(x * 0.037F, -0.006F, 0.175F, 0.012F),
                               at.knot(x * 0.016F, 0.000F, 0.212F, 0.012F)},
                              6, at.axes[1])),
              {0.010F, kJade, true});
    }
    // Folds across the bridge of the nose.
    for (int i = 0; i < 5; ++i) {
        const float z = 0.088F + 0.019F * static_cast<float>(i);
        s.add(tube(make_curve(
                  {at.knot(-0.028F, 0.024F, z - 0.010F, 0.0055F), at.knot(0.0F, 0.042F, z, 0.0070F),
                   at.knot(0.028F, 0.024F, z - 0.010F, 0.0055F)},
                  5, at.axes[2])),
              {0.006F, kJade, true});
    }
}

void add_eyes(Sculpture& s, const Placed& at) {
    for (const float x : kSides) {
        s.carve(ball(at(x * 0.053F, 0.036F, 0.058F), 0.0215F), {0.008F, kDeep, true});
        s.add(ball(at(x * 0.045F, 0.036F, 0.056F), 0.0185F), {0.001F, kPale, true});
        // The pupil: a shallow dish in the middle of what the lids leave free.
        s.carve(ball(at(x * 0.0695F, 0.0360F, 0.0632F), 0.0090F), {0.002F, kDeep, true});
        // Lids, then the heavy brow that sweeps up behind.
        s.add(tube(make_curve({at.knot(x * 0.036F, 0.034F, 0.080F, 0.0045F),
                               at.knot(x * 0.057F, 0.0505F, 0.064F, 0.0055F),
                               at.knot(x * 0.062F, 0.042F, 0.036F, 0.0050F)},
                              6, at.axes[1])),
              {0.003F, kJade, true});
        s.add(tube(make_curve({at.knot(x * 0.036F, 0.032F, 0.080F, 0.0040F),
                               at.knot(x * 0.060F, 0.020F, 0.062F, 0.0050F),
                               at.knot(x * 0.062F, 0.034F, 0.034F, 0.0045F)},
                              6, at.axes[1])),
              {0.003F, kJade, true});
        s.add(tube(make_curve({at.knot(x * 0.022F, 0.046F, 0.096F, 0.008F),
                               at.knot(x * 0.046F, 0.066F, 0.068F, 0.014F, 0.010F),
                               at.knot(x * 0.066F, 0.074F, 0.026F, 0.014F, 0.010F),
                               at.knot(x * 0.082F, 0.096F, -0.014F, 0.004F)},
                              6, at.axes[1])),
              {0.008F, kJade, true});
        for (int i = 0; i < 4; ++i) {
            const float t = static_cast<float>(i) / 3.0F;
            const glm::vec3 root = at(x * (0.044F + 0.024F * t), 0.074F, 0.066F - 0.050F * t);
            s.add(round_cone(root, 0.006F, root + at.axes * glm::vec3(x * 0.012F, 0.020F, -0.014F),
                             0.0015F),
                  {0.004F, kDeep, true});
        }
        s.carve(tube(make_curve({at.knot(x * 0.020F, 0.040F, 0.226F, 0.0095F),
                                 at.knot(x * 0.028F, 0.040F, 0.208F, 0.0080F),
                                 at.knot(x * 0.032F, 0.036F, 0.186F, 0.0040F)},
                                4, at.axes[1])),
                {0.003F, kDeep, true});
    }
}

void add_jaw(Sculpture& s, const Placed& jaw) {
    s.add(tube(make_curve({jaw.knot(0, -0.016F, -0.025F, 0.046F, 0.030F),
                           jaw.knot(0, -0.018F, 0.04F, 0.042F, 0.021F),
                           jaw.knot(0, -0.016F, 0.11F, 0.033F, 0.015F),
                           jaw.knot(0, -0.010F, 0.170F, 0.025F, 0.016F)},
                          6, jaw.axes[0])),
          {0.018F, kJade, true});
    s.carve(tube(make_curve({jaw.knot(0, 0.004F, 0.00F, 0.030F, 0.014F),
                             jaw.knot(0, 0.004F, 0.08F, 0.028F, 0.014F),
                             jaw.knot(0, 0.006F, 0.155F, 0.018F, 0.010F)},
                            6, jaw.axes[0])),
            {0.008F, kDeep, true});
    for (const float x : kSides) {
        s.add(tube(make_curve({jaw.knot(x * 0.050F, 0.012F, -0.005F, 0.009F),
                               jaw.knot(x * 0.042F, -0.006F, 0.040F, 0.009F),
                               jaw.knot(x * 0.036F, -0.004F, 0.100F, 0.008F),
                               jaw.knot(x * 0.027F, 0.002F, 0.155F, 0.0085F),
                               jaw.knot(0.0F, 0.000F, 0.188F, 0.0085F)},
                              6, jaw.axes[1])),
              {0.006F, kJade, true});
    }
    const Curve tongue = make_curve(
        {jaw.knot(0, 0.000F, -0.02F, 0.020F, 0.010F), jaw.knot(0, 0.012F, 0.06F, 0.020F, 0.008F),
         jaw.knot(0.002F, 0.016F, 0.13F, 0.016F, 0.006F),
         jaw.knot(0.004F, 0.038F, 0.185F, 0.011F, 0.005F),
         jaw.knot(0.006F, 0.066F, 0.196F, 0.003F, 0.003F)},
        6, jaw.axes[0]);
    s.add(tube(tongue), {0.004F, kPale, true});
    s.carve(tube(make_curve({jaw.knot(0, 0.021F, 0.05F, 0.002F), jaw.knot(0, 0.023F, 0.13F, 0.002F),
                             jaw.knot(0.003F, 0.042F, 0.178F, 0.0015F)},
                            6, jaw.axes[0])),
            {0.003F, kPale, false});
}

/// A row of teeth that point along `way` (+1 up, -1 down) from the rim of a jaw.
void add_teeth(Sculpture& s, const Placed& at, float way, const std::array<glm::vec3, 7>& roots,
               const std::array<float, 7>& lengths_m) {
    for (const float x : kSides) {
        for (std::size_t i = 0; i < roots.size(); ++i) {
            const glm::vec3 r = roots[i];
            const float thick = 0.0032F + 0.10F * lengths_m[i];
            const Curve tooth = make_curve(
                {at.knot(x * r.x, r.y - way * 0.004F, r.z, thick),
                 at.knot(x * r.x, r.y + way * 0.5F * lengths_m[i], r.z + 0.004F, 0.72F * thick),
                 at.knot(x * (r.x - 0.002F), r.y + way * lengths_m[i], r.z - 0.003F, 0.0012F)},
                3, at.axes[2]);
            s.add(tube(tooth), {0.002F, kPale, true});
        }
    }
}

void add_horns(Sculpture& s, const Placed& at) {
    const Relief rings = [](const TubePoint& p) {
        const float wave = std::sin(p.along_m * 2.0F * std::numbers::pi_v<float> / 0.014F);
        return 0.0014F * wave * std::min(1.0F, 0.22F / std::max(p.along_m, 0.2F)) *
               (p.along_m < 0.17F ? 1.0F : 0.3F);
    };
    for (const float x : kSides) {
        const Curve horn = make_curve({at.knot(x * 0.030F, 0.050F, -0.020F, 0.019F),
                                       at.knot(x * 0.046F, 0.095F, -0.060F, 0.016F),
                                       at.knot(x * 0.066F, 0.120F, -0.130F, 0.0125F),
                                       at.knot(x * 0.084F, 0.165F, -0.190F, 0.0090F),
                                       at.knot(x * 0.090F, 0.225F, -0.215F, 0.0025F)},
                                      8, at.axes[2]);
        s.add(tube(horn, {false, rings, 0.0015F}), {0.006F, kPale, true});
        const Curve branch = make_curve({at.knot(x * 0.058F, 0.108F, -0.100F, 0.0115F),
                                         at.knot(x * 0.072F, 0.142F, -0.098F, 0.0085F),
                                         at.knot(x * 0.080F, 0.178F, -0.116F, 0.0022F)},
                                        6, at.axes[2]);
        s.add(tube(branch), {0.008F, kPale, true});
        // Ear: a leaf with a hollow.
        const glm::mat3 lean =
            at.axes * axes_from(glm::normalize(glm::vec3(x * 0.75F, 0.35F, -0.62F)),
                                glm::vec3(x * 0.4F, -0.2F, 0.6F));
        s.add(ellipsoid(at(x * 0.088F, 0.032F, -0.048F), {0.019F, 0.010F, 0.044F}, lean),
              {0.008F, kJade, true});
        s.carve(ellipsoid(at(x * 0.090F, 0.034F, -0.038F) + lean[1] * 0.009F,
                          {0.011F, 0.008F, 0.032F}, lean),
                {0.003F, kDeep, true});
    }
}

void add_whiskers_and_beard(Sculpture& s, const Placed& at, const Placed& jaw) {
    for (const float x : kSides) {
        s.add(tube(make_curve({at.knot(x * 0.034F, 0.018F, 0.190F, 0.0070F),
                               at.knot(x * 0.066F, 0.026F, 0.205F, 0.0058F),
                               at.knot(x * 0.094F, 0.000F, 0.165F, 0.0052F),
                               at.knot(x * 0.098F, -0.040F, 0.110F, 0.0046F),
                               at.knot(x * 0.116F, -0.050F, 0.050F, 0.0040F),
                               at.knot(x * 0.135F, -0.020F, 0.010F, 0.0026F)},
                              7, at.axes[1])),
              {0.006F, kPale, true});
    }
    for (int i = -2; i <= 2; ++i) {
        const auto t = static_cast<float>(i);
        const float drop = 0.10F - 0.014F * std::abs(t);
        s.add(tube(make_curve({jaw.knot(0.009F * t, -0.014F, 0.150F, 0.008F),
                               jaw.knot(0.013F * t, -0.044F, 0.160F, 0.0075F),
                               jaw.knot(0.016F * t, -0.010F - 0.65F * drop, 0.128F, 0.006F),
                               jaw.knot(0.020F * t, -0.020F - drop, 0.140F, 0.0018F)},
                              6, jaw.axes[2])),
              {0.005F, kPale, true});
    }
}

}  // namespace

Placed head_place() {
    const glm::vec3 forward = glm::normalize(glm::vec3(-0.86F, -0.10F, 0.50F));
    return {glm::vec3(-0.150F, 0.945F, 0.135F), axes_from(forward, glm::vec3(0.0F, 1.0F, 0.12F))};
}

void add_head(Sculpture& sculpture) {
    const Placed at = head_place();
    const Placed jaw = jaw_place(at);
    add_skull(sculpture, at);
    add_jaw(sculpture, jaw);
    // The hollow of the mouth: palate and throat.
    sculpture.carve(tube(make_curve({at.knot(0, -0.030F, 0.00F, 0.028F, 0.022F),
                                     at.knot(0, -0.022F, 0.08F, 0.028F, 0.020F),
                                     at.knot(0, -0.012F, 0.165F, 0.020F, 0.012F)},
                                    6, at.axes[0])),
                    {0.006F, kDeep, true});
    add_eyes(sculpture, at);
    add_teeth(sculpture, at, -1.0F,
              {glm::vec3(0.008F, -0.004F, 0.208F), glm::vec3(0.022F, -0.006F, 0.200F),
               glm::vec3(0.033F, -0.010F, 0.176F), glm::vec3(0.036F, -0.016F, 0.150F),
               glm::vec3(0.038F, -0.020F, 0.122F), glm::vec3(0.041F, -0.018F, 0.092F),
               glm::vec3(0.044F, -0.016F, 0.062F)},
              {0.015F, 0.018F, 0.040F, 0.018F, 0.021F, 0.018F, 0.015F});
    add_teeth(sculpture, jaw, 1.0F,
              {glm::vec3(0.007F, 0.004F, 0.184F), glm::vec3(0.019F, 0.006F, 0.172F),
               glm::vec3(0.026F, 0.006F, 0.152F), glm::vec3(0.031F, 0.004F, 0.126F),
               glm::vec3(0.035F, 0.002F, 0.100F), glm::vec3(0.038F, 0.001F, 0.074F),
               glm::vec3(0.041F, 0.002F, 0.050F)},
              {0.014F, 0.032F, 0.018F, 0.016F, 0.017F, 0.016F, 0.013F});
    add_horns(sculpture, at);
    add_whiskers_and_beard(sculpture, at, jaw);
}

void add_mane(Sculpture& sculpture) {
    const Placed at = head_place();
    constexpr int kLocks = 13;
    for (int ring = 0; ring < 2; ++ring) {
        for (int i = 0; i < kLocks; ++i) {
            const float turn = (static_cast<float>(i) + 0.5F * static_cast<float>(ring)) / kLocks;
            const float angle = 2.0F * std::numbers::pi_v<float> * turn;
            const float c = std::cos(angle);
            const float s = std::sin(angle);
            const float back = ring == 0 ? -0.030F : -0.060F;
            const float flare = (ring == 0 ? 1.0F : 0.86F) * (0.9F + 0.1F * std::cos(3.0F * angle));
            const float curl = i % 2 == 0 ? 0.016F : -0.016F;
            const auto lock = [&](float radius, float forward, float twist, float w, float h) {
                return at.knot(radius * c - twist * s, radius * s + twist * c, forward, w, h);
            };
            sculpture.add(
                tube(make_curve({lock(0.044F, back, 0.0F, 0.013F, 0.009F),
                                 lock(0.084F * flare, back - 0.030F, curl, 0.016F, 0.009F),
                                 lock(0.105F * flare, back - 0.080F, -0.4F * curl, 0.012F, 0.008F),
                                 lock(0.140F * flare, back - 0.105F, curl, 0.002F, 0.002F)},
                                6, at.axes * glm::vec3(-s, c, 0.0F))),
                {0.004F, kDeep, true});
        }
    }
}

}  // namespace obscura::stimuli::relic
