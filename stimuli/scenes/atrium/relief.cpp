// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/atrium/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kReliefRadius = 1.12F;
constexpr float kCentreY = 7.35F;

/// The larger of two heights, rounded where they meet over `k`.
float blend(float a, float b, float k) {
    const float h = std::clamp(0.5F + 0.5F * (a - b) / k, 0.0F, 1.0F);
    return glm::mix(b, a, h) + k * h * (1.0F - h);
}

/// Half an ellipsoid's height above the ground, 0 outside.
float dome(vec2 p, vec2 centre, vec2 radii, float height) {
    const vec2 q = (p - centre) / radii;
    return height * std::sqrt(std::max(0.0F, 1.0F - glm::dot(q, q)));
}

float bump(vec2 p, vec2 centre, vec2 radii) {
    const vec2 q = (p - centre) / radii;
    return std::exp(-glm::dot(q, q));
}

float mane(vec2 p) {
    const float r = glm::length(p - vec2(0.0F, -0.03F));
    const float angle = std::atan2(p.x, p.y);
    float height = 0.0F;
    // Three rings of locks, each half a lock further round and swung a little.
    for (int ring = 0; ring < 3; ++ring) {
        const auto k = static_cast<float>(ring);
        const float inner = 0.40F + 0.14F * k;
        const float outer = 0.68F + 0.15F * k;
        const float t = (r - inner) / (outer - inner);
        if (t < 0.0F || t > 1.0F) continue;
        const float locks = 15.0F + 4.0F * k;
        const float swing = 0.9F * t * t + 0.35F * std::sin(3.0F * angle + k);
        const float phase = angle * locks / glm::two_pi<float>() + 0.5F * k + swing * 0.6F;
        const float across = 2.0F * (phase - std::floor(phase)) - 1.0F;
        const float width = std::sqrt(std::max(0.0F, 1.0F - t * t));
        const float body = std::max(0.0F, 1.0F - across * across / (width * width + 1e-3F));
        const float strands = 0.9F + 0.1F * std::cos(across * 9.0F);
        const float level = 0.25F - 0.065F * k;
        height = std::max(height, (level + 0.14F * std::sqrt(body) * strands) *
                                      glm::smoothstep(1.0F, 0.8F, t) * (body > 0.0F ? 1.0F : 0.0F));
    }
    return height;
}

/// Height of a lion's mask over the unit disc; symmetric in x but for its mane.
float lion(vec2 p) {
    const vec2 face_p = (p + vec2(0.0F, -0.02F)) / 1.22F;
    const vec2 q(std::abs(face_p.x), face_p.y);
    float face = dome(q, {0.0F, 0.0F}, {0.44F, 0.58F}, 0.44F);
    face = blend(face, dome(q, {0.2F, -0.1F}, {0.19F, 0.2F}, 0.46F), 0.06F);
    face = blend(face, dome(q, {0.15F, 0.22F}, {0.19F, 0.1F}, 0.56F), 0.05F);
    face += 0.12F * bump(q, {0.0F, 0.08F}, {0.08F, 0.22F});
    face += 0.17F * bump(q, {0.0F, -0.09F}, {0.115F, 0.06F});
    face = blend(face, dome(q, {0.1F, -0.21F}, {0.155F, 0.125F}, 0.64F), 0.03F);
    face = blend(face, dome(q, {0.0F, -0.47F}, {0.17F, 0.12F}, 0.52F), 0.03F);
    face -= 0.34F * bump(q, {0.0F, -0.365F}, {0.17F, 0.05F});
    face += 0.12F * bump(q, {0.095F, -0.335F}, {0.018F, 0.035F});
    face -= 0.06F * bump(q, {0.0F, -0.2F}, {0.012F, 0.1F});
    face -= 0.10F * bump(q, {0.055F, -0.125F}, {0.03F, 0.022F});
    face -= 0.20F * bump(q, {0.18F, 0.085F}, {0.1F, 0.055F});
    face += 0.15F * bump(q, {0.175F, 0.08F}, {0.05F, 0.036F});
    face -= 0.06F * bump(q, {0.0F, 0.3F}, {0.02F, 0.12F});
    face -= 0.04F * bump(q, {0.08F, 0.33F}, {0.02F, 0.07F});
    const float whiskers =
        0.012F * std::cos(60.0F * (q.y + 0.5F * q.x)) * bump(q, {0.16F, -0.22F}, {0.09F, 0.07F});
    const float ear = dome(q, {0.37F, 0.42F}, {0.14F, 0.15F}, 0.5F) -
                      0.2F * bump(q, {0.37F, 0.41F}, {0.07F, 0.08F});
    return blend(blend(face + whiskers, ear, 0.04F), mane(p), 0.05F);
}

}  // namespace

void build_relief(Site& site) {
    const glm::mat4 frame = at(0.0F, kCentreY, -kHalfLength + 0.03F);
    PatchOptions options;
    options.columns = 140;
    options.rows = 58;
    options.closed_u = true;
    options.size_m = {glm::two_pi<float>() * kReliefRadius, kReliefRadius};
    Mesh mask = patch(options, [](float u, float v) {
        const float angle = glm::two_pi<float>() * u;
        const float r = 1.0F - v;  // from the rim inwards: the outside is +z
        const vec2 p(r * std::cos(angle), r * std::sin(angle));
        const float rim = glm::smoothstep(1.0F, 0.96F, r);
        const float chipped = 0.012F * fbm(vec3(p * 6.0F, 0.0F), 5, 3);
        return kReliefRadius * vec3(p, rim * (0.62F * lion(p) + chipped));
    });
    for (renderer::Vertex& vertex : mask.vertices) {
        vertex.uv = vec2(vertex.position_m.x, -vertex.position_m.y);
        // Hollows keep the dust and soot of centuries.
        const float depth = std::clamp(vertex.position_m.z / (0.3F * kReliefRadius), 0.0F, 1.0F);
        vertex.color = glm::u8vec4(
            glm::vec4(glm::mix(vec3(112.0F, 100.0F, 86.0F), vec3(255.0F), depth), 255.0F));
    }
    make_tangents(mask);
    site.put(Surface::kStone, mask, frame, 70000U);
    // A moulded ring around it, of blocks.
    constexpr int kBlocks = 24;
    const std::vector<vec2> section{{-0.1F, -0.1F},  {0.14F, -0.1F},  {0.14F, 0.06F},
                                    {0.11F, 0.08F},  {0.08F, 0.12F},  {0.02F, 0.14F},
                                    {-0.04F, 0.12F}, {-0.06F, 0.08F}, {-0.1F, 0.07F}};
    for (int i = 0; i < kBlocks; ++i) {
        std::vector<ProfileFrame> frames;
        for (int k = 0; k <= 4; ++k) {
            const float turn =
                (static_cast<float>(i) + 0.008F + 0.984F * static_cast<float>(k) / 4) / kBlocks *
                glm::two_pi<float>();
            const vec3 out(std::cos(turn), std::sin(turn), 0.0F);
            // x outwards, y towards the court: the path runs along out cross z, clockwise.
            frames.insert(frames.begin(),
                          {out * (kReliefRadius + 0.04F), out, vec3(0.0F, 0.0F, 1.0F)});
        }
        const auto own = 70100U + static_cast<std::uint32_t>(i);
        site.put(Surface::kStone, sweep(section, frames), frame, own, shade(own, 0.16F));
    }
}

}  // namespace obscura::stimuli::atrium
