// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::figures {
namespace {

/// Rises softly from 0 at `from` to 1 at `to`, which may be the smaller one.
float ramp(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// How much of the skin the eyebrows cover. They rise from the nose, turn over the outer third of
/// the eye and thin out.
float brow_cover(const glm::vec3& q, float weight) {
    if (q.z < 0.03F || q.y < 0.004F || q.y > 0.034F) return 0.0F;
    const float x = std::abs(q.x);
    const float t = (x - 0.0125F) / (0.0560F - 0.0125F);
    if (t < -0.1F || t > 1.1F) return 0.0F;
    const float middle = 0.0142F + 0.0080F * std::sin(2.35F * std::clamp(t, 0.0F, 1.0F)) -
                         0.0045F * ramp(0.6F, 1.0F, t);
    const float half = weight * (0.0046F - 0.0030F * ramp(0.40F, 1.0F, t));
    // Hairs lie along the brow, upwards near the nose.
    const float across = (q.y - middle) / half;
    const float hairs =
        gradient_noise(glm::vec3(x * 300.0F - q.y * 500.0F, q.y * 900.0F, 0.0F), 45);
    const float edge = 1.0F - std::abs(across) + 0.45F * hairs;
    return ramp(-0.12F, 0.28F, edge) * ramp(-0.06F, 0.14F, t) * ramp(1.06F, 0.80F, t) *
           (0.86F + 0.14F * hairs);
}

/// How much of the skin hair covers at its roots: soft, since no two hairs begin in one line.
float scalp_cover(const glm::vec3& q, const std::function<float(float)>& hairline) {
    if (!hairline) return 0.0F;
    const glm::vec3 way = (q - kScalpMiddle) / kScalpRadii;
    const float rise = std::atan2(way.y, std::sqrt(way.x * way.x + way.z * way.z));
    const float begins = hairline(std::abs(std::atan2(way.x, way.z)));
    const float ragged =
        0.05F * gradient_noise(q * 240.0F, 46) + 0.03F * gradient_noise(q * 90.0F, 48);
    return ramp(-0.09F, 0.10F, rise - begins + ragged);
}

}  // namespace

glm::vec3 complexion_at(const glm::vec3& q, const FaceTraits& traits) {
    const glm::vec3 mirrored(std::abs(q.x), q.y, q.z);
    const auto near = [&](const glm::vec3& centre, float reach) {
        const float away = glm::length(mirrored - centre) / reach;
        return std::exp(-away * away);
    };
    const float mottle = fbm(q * 55.0F, 41, 3);
    glm::vec3 colour(1.0F + 0.05F * mottle, 1.0F + 0.10F * mottle, 1.0F + 0.09F * mottle);
    const auto towards = [&](const glm::vec3& other, float share) {
        colour *= glm::mix(glm::vec3(1.0F), other, std::clamp(share, 0.0F, 1.0F));
    };
    const glm::vec3 blood(1.02F, 0.80F, 0.76F);
    towards(blood, (0.65F + 0.5F * mottle) * near({0.040F, -0.032F, 0.070F}, 0.024F));
    towards(blood, 0.75F * near({0.0F, -0.036F, 0.108F}, 0.016F));
    towards(blood, 0.5F * near({0.012F, -0.043F, 0.095F}, 0.010F));
    towards(blood, 0.35F * near({0.0F, -0.105F, 0.090F}, 0.016F));
    towards(blood, 0.55F * std::clamp((std::abs(q.x) - 0.069F) / 0.010F, 0.0F, 1.0F));
    // The forehead is yellower, the lids and the corners of the eyes redder and darker.
    towards({0.98F, 0.97F, 0.90F}, 0.7F * near({0.015F, 0.045F, 0.080F}, 0.030F));
    towards({0.76F, 0.66F, 0.68F}, 0.65F * traits.age * near({0.029F, -0.0125F, 0.078F}, 0.010F));
    towards({0.80F, 0.68F, 0.66F}, 0.60F * near({0.031F, 0.0070F, 0.079F}, 0.009F));
    towards({0.78F, 0.64F, 0.62F}, 0.60F * near({0.0165F, -0.002F, 0.078F}, 0.006F));
    towards({0.84F, 0.74F, 0.72F}, 0.50F * near({0.0270F, -0.073F, 0.083F}, 0.007F));
    // A shaven beard: lip, chin and jaw up to the ears, not the cheeks.
    const float below =
        std::clamp((-0.046F - q.y + 0.30F * std::max(0.0F, q.z - 0.050F)) / 0.016F, 0.0F, 1.0F);
    const float throat = std::clamp((q.y + 0.140F) / 0.030F, 0.0F, 1.0F);
    const float stubble =
        0.72F + 0.5F * gradient_noise(q * 420.0F, 43) + 0.2F * gradient_noise(q * 120.0F, 44);
    towards({0.60F, 0.62F, 0.66F},
            traits.beard * below * throat * stubble * std::clamp(q.z / 0.02F + 0.6F, 0.0F, 1.0F));
    const auto covered = [&](const glm::vec3& hair, float share) {
        colour = glm::mix(colour, hair / traits.skin, std::clamp(share, 0.0F, 1.0F));
    };
    covered(traits.brows, 0.97F * brow_cover(q, traits.brow_weight));
    covered(traits.hair * 0.8F, 0.95F * scalp_cover(q, traits.hairline));
    return colour;
}

}  // namespace obscura::stimuli::figures
