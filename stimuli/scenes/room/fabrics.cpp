// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/room/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::room {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

namespace {

/// A curtain that hangs from y = 0 down, gathered along z; folds deepen and wander downwards.
Mesh hanging(float width, float drop, int folds, std::uint32_t seed) {
    PatchOptions options;
    options.columns = folds * 12;
    options.rows = 56;
    options.size_m = {2.2F * width, -drop};
    Mesh mesh = patch(options, [&](float u, float v) {
        const float down = 1.0F - v;
        const float wander = 0.10F * fbm(vec2(4.0F * u, 1.6F * down), seed, 3) * down;
        const float phase = glm::two_pi<float>() * static_cast<float>(folds) * (u + 0.35F * wander);
        const float own =
            0.7F + 0.6F * value_noise(vec2(u * static_cast<float>(folds), 0.5F), seed + 3U);
        const float deep = glm::mix(0.020F, 0.045F, glm::smoothstep(0.0F, 0.25F, down)) * own;
        const float fold = std::sin(phase) + 0.22F * std::sin(2.0F * phase + 1.3F);
        const float gather = 1.0F + 0.05F * std::sin(3.0F * down);
        // The hem just touches the floor and is pushed about a little.
        return vec3(deep * fold + 0.015F * fbm(vec2(6.0F * u, 5.0F * down), seed + 5U, 3),
                    -drop * down,
                    width * (0.5F - u) * gather + 0.008F * std::cos(phase) + 0.3F * wander * width);
    });
    for (renderer::Vertex& vertex : mesh.vertices) vertex.tangent.w = -1.0F;
    return mesh;
}

void put_curtains(Assembly& study) {
    const float rail_y = kLintel + 0.20F;
    const float x = kLeft + 0.13F;
    const float middle = 0.5F * (kWindowBack + kWindowFront);
    const float half = 0.5F * (kWindowFront - kWindowBack);
    std::uint32_t seed = 100;
    for (const float side : {-1.0F, 1.0F}) {
        const float width = side < 0.0F ? 0.40F : 0.46F;
        const float z = middle + side * (half + 0.10F);
        study.put(Surface::kCurtain, hanging(width, rail_y - 0.055F, 7, seed),
                  moved(x, rail_y - 0.045F, z), seed);
        for (int i = 0; i < 7; ++i) {
            const float at_z = z + width * (0.43F - 0.143F * static_cast<float>(i));
            study.put(Surface::kMetal, ring(0.022F, 0.0025F, 20, 6),
                      moved(x, rail_y - 0.010F, at_z) * lie_along_z(), seed);
        }
        const std::array<vec2, 7> finial{{{0.0F, 0.0F},
                                          {0.02F, 0.0F},
                                          {0.014F, 0.02F},
                                          {0.034F, 0.04F},
                                          {0.034F, 0.055F},
                                          {0.02F, 0.075F},
                                          {0.0F, 0.08F}}};
        study.put(Surface::kWood, revolve(finial, 20),
                  moved(x, rail_y, middle + side * (half + 0.38F)) *
                      about_x(side * glm::half_pi<float>()),
                  seed);
        study.put(Surface::kWood, bevelled_box({0.14F, 0.03F, 0.03F}, 0.006F),
                  moved(kLeft + 0.07F, rail_y, middle + side * (half + 0.33F)), seed);
        seed += 7;
    }
    study.put(
        Surface::kWood,
        rod({x, rail_y, middle - half - 0.38F}, {x, rail_y, middle + half + 0.38F}, 0.014F, 16),
        glm::mat4(1.0F), 120U);
}

/// A rug that is not quite flat, with fringes.
void put_rug(Assembly& study) {
    constexpr float kLength = 2.3F;
    constexpr float kWidth = 1.5F;
    const glm::mat4 place = moved(-0.35F, 0.0F, 0.05F) * about_y(0.06F);
    PatchOptions options;
    options.columns = 110;
    options.rows = 72;
    Mesh mesh = patch(options, [](float u, float v) {
        const float edge = std::min({u, 1.0F - u, v, 1.0F - v});
        const float wave = 0.010F * std::max(0.0F, fbm(vec2(3.0F * u, 2.0F * v), 77, 3));
        const float round = glm::smoothstep(0.0F, 0.010F, edge);
        return vec3((u - 0.5F) * kLength,
                    0.001F + 0.010F * round + wave * glm::smoothstep(0.0F, 0.06F, edge),
                    (0.5F - v) * kWidth);
    });
    study.put_mapped(Surface::kRug, mesh, place);
    base::Random random(7);
    for (const float side : {-1.0F, 1.0F}) {
        for (int i = 0; i < 96; ++i) {
            const float z = kWidth * ((static_cast<float>(i) + 0.5F) / 96.0F - 0.5F);
            const vec3 root(side * 0.5F * kLength, 0.005F, z);
            const std::array<vec3, 3> tassel{
                {root, root + vec3(side * 0.03F, 0.004F, draw(random, -0.006F, 0.006F)),
                 root +
                     vec3(side * draw(random, 0.05F, 0.07F), 0.003F, draw(random, -0.02F, 0.02F))}};
            study.put(Surface::kPaper,
                      sweep(circle(0.0032F, 5), frames_along(tassel, {0.0F, 1.0F, 0.0F})), place,
                      130U, vec3(0.8F, 0.74F, 0.62F));
        }
    }
}

/// Base, arms, back and cushions with piped seams.
void put_armchair(Assembly& study, const glm::mat4& place) {
    const auto soft = [&](const vec3& size, const vec3& at, float bulge, float lean,
                          std::uint32_t seed) {
        study.put(Surface::kUpholstery, cushion(size, bulge), place * moved(at) * about_x(lean),
                  seed, shade_of(seed, 0.08F));
    };
    soft({0.80F, 0.22F, 0.74F}, {0.0F, 0.25F, 0.0F}, 0.008F, 0.0F, 140U);
    for (const float side : {-1.0F, 1.0F}) {
        soft({0.16F, 0.40F, 0.78F}, {side * 0.36F, 0.42F, 0.0F}, 0.012F, 0.0F, 141U);
        soft({0.20F, 0.12F, 0.80F}, {side * 0.36F, 0.60F, 0.01F}, 0.02F, 0.0F, 142U);
    }
    soft({0.76F, 0.72F, 0.18F}, {0.0F, 0.62F, -0.33F}, 0.02F, -0.16F, 143U);
    soft({0.55F, 0.15F, 0.60F}, {0.0F, 0.43F, 0.08F}, 0.03F, 0.0F, 144U);
    soft({0.54F, 0.50F, 0.16F}, {0.0F, 0.72F, -0.20F}, 0.04F, -0.20F, 145U);
    for (const float x : {-0.34F, 0.34F}) {
        for (const float z : {-0.30F, 0.30F}) {
            const std::array<vec2, 6> foot{{{0.0F, 0.0F},
                                            {0.018F, 0.0F},
                                            {0.022F, 0.02F},
                                            {0.030F, 0.08F},
                                            {0.034F, 0.15F},
                                            {0.0F, 0.15F}}};
            study.put(Surface::kWood, revolve(foot, 18), place * moved(x, 0.0F, z), 146U);
        }
    }
    // Piping round the seat cushion's upper and lower edge.
    for (const float y : {0.385F, 0.475F}) {
        const std::array<vec3, 6> seam{{{-0.26F, y, 0.0F},
                                        {-0.26F, y, 0.365F},
                                        {0.0F, y, 0.372F},
                                        {0.26F, y, 0.365F},
                                        {0.26F, y, 0.0F},
                                        {0.26F, y, -0.1F}}};
        study.put(Surface::kUpholstery, pipe(seam, 0.06F, 0.006F, 8), place, 147U, vec3(0.7F));
    }
    study.put(Surface::kCurtain, cushion({0.40F, 0.38F, 0.13F}, 0.05F),
              place * moved(0.10F, 0.67F, -0.05F) * about_x(-0.42F) * about_z(0.35F), 148U,
              vec3(0.9F, 0.75F, 0.45F));
}

/// A folded blanket over the chair's arm.
void put_throw(Assembly& study, const glm::mat4& place) {
    PatchOptions options;
    options.columns = 48;
    options.rows = 40;
    options.size_m = {1.0F, -0.5F};
    Mesh mesh = patch(options, [](float u, float v) {
        // Over the arm, which swells by 2 cm: inside down to the seat, across its top, outside
        // down.
        const float s = (u - 0.27F) * 0.97F;
        const float top = 0.118F;
        const float ripple = 0.009F * (1.0F + std::sin(26.0F * v + 3.0F * s)) *
                             glm::smoothstep(0.08F, 0.4F, std::abs(s));
        const float z = (0.5F - v) * 0.40F + 0.02F * std::sin(7.0F * s);
        const float round = 0.021F * (1.0F - (s / top) * (s / top));
        if (std::abs(s) < top) return vec3(s, 0.668F + round, z);
        const float side = s < 0.0F ? -1.0F : 1.0F;
        return vec3(side * (top + 0.012F + ripple), 0.668F - (std::abs(s) - top), z);
    });
    study.put(Surface::kBinding, mesh, place, 150U, vec3(0.32F, 0.40F, 0.42F));
}

}  // namespace

Mesh cushion(const vec3& size_m, float bulge_m) {
    PatchOptions options;
    options.columns = 40;
    options.rows = 24;
    options.closed_u = true;
    options.size_m = {2.0F * (size_m.x + size_m.z), size_m.y};
    const auto power = [](float value, float exponent) {
        // In single precision the sine of a half or a whole turn is not quite 0, which the power
        // makes a hundredth: the seam would lie over itself.
        if (std::abs(value) < 1e-6F) return 0.0F;
        return std::copysign(std::pow(std::abs(value), exponent), value);
    };
    Mesh mesh = patch(options, [&](float u, float v) {
        const float a = glm::two_pi<float>() * u;
        const float b = glm::pi<float>() * (v - 0.5F);
        constexpr float kSquare = 0.28F;
        const float flat = power(std::max(std::cos(b), 0.0F), kSquare);
        vec3 p(power(std::sin(a), kSquare) * flat, power(std::sin(b), kSquare),
               power(std::cos(a), kSquare) * flat);
        const vec3 inner = 1.0F - p * p;
        const vec3 swell(inner.y * inner.z, inner.x * inner.z, inner.x * inner.y);
        const vec3 out(p.x > 0.0F ? 1.0F : -1.0F, p.y > 0.0F ? 1.0F : -1.0F,
                       p.z > 0.0F ? 1.0F : -1.0F);
        return 0.5F * size_m * p + bulge_m * glm::max(swell, vec3(0.0F)) * out * glm::abs(p);
    });
    project_box_uv(mesh);
    return mesh;
}

void build_fabrics(Assembly& study) {
    put_curtains(study);
    put_rug(study);
    const glm::mat4 chair = moved(-1.62F, 0.0F, 0.78F) * about_y(2.05F);
    put_armchair(study, chair);
    put_throw(study, chair * moved(0.36F, 0.0F, 0.0F));
}

}  // namespace obscura::stimuli::room
