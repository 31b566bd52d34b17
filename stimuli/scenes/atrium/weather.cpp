// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "stimuli/scenes/atrium/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec3;

/// Rain leaves dark tongues below a ledge at `ledge_y`, about `reach_m` long.
float streaks(const vec3& p, const vec3& normal, float ledge_y, float reach_m, std::uint32_t seed) {
    const float below = ledge_y - p.y;
    if (below < 0.0F || std::abs(normal.y) > 0.5F) return 0.0F;
    const float along = std::abs(normal.x) > std::abs(normal.z) ? p.z : p.x;
    const float tongue = value_noise(glm::vec2(along * 3.1F, 0.5F), seed) *
                         (0.6F + 0.4F * value_noise(glm::vec2(along * 9.0F, p.y), seed + 1U));
    return tongue * std::exp(-below / (reach_m * (0.3F + tongue)));
}

vec3 masonry_tone(const vec3& p, const vec3& normal) {
    const float broad = fbm(p * 0.45F, 501, 3);
    const float medium = fbm(p * 1.9F, 502, 3);
    float tone = 0.90F + 0.16F * broad + 0.12F * medium;
    const vec3 warm =
        glm::mix(vec3(1.0F), vec3(1.0F, 0.955F, 0.88F), glm::clamp(0.5F + broad, 0.0F, 1.0F));
    vec3 colour = warm;
    // Long runs of old rain, broad and faint.
    if (std::abs(normal.y) < 0.5F) {
        const float run = value_noise(vec3(p.x * 5.0F, p.y * 0.35F, p.z * 5.0F), 504);
        tone *= 1.0F - 0.22F * glm::smoothstep(0.55F, 0.95F, run);
    }
    // Splashing rain and boots at the foot of both storeys.
    for (const float floor_y : {0.0F, kGalleryFloor}) {
        const float above = p.y - floor_y;
        if (above < -0.05F) continue;
        const float damp = std::exp(-above / (0.28F + 0.22F * medium));
        tone *= 1.0F - 0.38F * damp;
        colour = glm::mix(colour, vec3(0.86F, 0.9F, 0.78F), 0.35F * damp);
    }
    if (std::abs(p.x) < kArcadeX) {
        const float soot = std::min(1.0F, streaks(p, normal, kLowerTop + 0.3F, 1.6F, 511) +
                                              streaks(p, normal, kUpperTop + 0.5F, 1.2F, 513));
        tone *= 1.0F - 0.6F * soot;
        colour = glm::mix(colour, vec3(0.88F, 0.92F, 0.9F), soot);
        // What faces the sky collects dust and lichen.
        if (normal.y > 0.6F && p.y > 0.5F) {
            const float lichen = glm::smoothstep(0.0F, 0.4F, fbm(p * 4.0F, 515, 3));
            colour = glm::mix(colour, vec3(0.72F, 0.70F, 0.56F), 0.6F * lichen);
        }
    }
    return glm::clamp(colour * tone, 0.0F, 1.0F);
}

vec3 floor_tone(const vec3& p, const vec3& /*normal*/) {
    const float broad = fbm(p * 0.5F, 521, 3);
    const float stain = glm::smoothstep(0.15F, 0.5F, fbm(p * 1.3F, 522, 4));
    const float trodden = std::exp(-p.x * p.x / 1.6F);  // feet keep the middle pale
    const float tone = 0.9F + 0.1F * broad + 0.06F * trodden - 0.22F * stain;
    return glm::clamp(vec3(1.0F, 0.985F, 0.96F) * tone, 0.0F, 1.0F);
}

vec3 clay_tone(const vec3& p, const vec3& /*normal*/) {
    const float tile = value_noise(p * 4.3F, 531);
    const float broad = fbm(p * 0.7F, 532, 3);
    const vec3 smoke = glm::mix(vec3(1.0F), vec3(0.62F, 0.66F, 0.66F), tile);
    return glm::clamp(smoke * (0.85F + 0.25F * broad), 0.0F, 1.0F);
}

}  // namespace

void weather(Site& site) {
    for (const Surface surface : {Surface::kAshlar, Surface::kStone, Surface::kPlaster}) {
        paint(site.mesh(surface), masonry_tone);
    }
    paint(site.mesh(Surface::kFloor), floor_tone);
    paint(site.mesh(Surface::kRoof), clay_tone);
}

}  // namespace obscura::stimuli::atrium
