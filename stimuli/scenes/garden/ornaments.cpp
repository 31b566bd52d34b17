// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/garden/parts.h"

namespace obscura::stimuli::garden {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

/// A slab on two carved supports, with a back rail of balusters.
void put_bench(Assembly& garden, const glm::mat4& place) {
    garden.put(Surface::kStone, bevelled_box({1.50F, 0.075F, 0.46F}, 0.014F),
               place * moved(0.0F, 0.44F, 0.0F), 301U);
    garden.put(Surface::kStone, bevelled_box({1.42F, 0.03F, 0.40F}, 0.008F),
               place * moved(0.0F, 0.39F, 0.0F), 302U);
    for (const float x : {-0.56F, 0.56F}) {
        garden.put(Surface::kStone, bevelled_box({0.17F, 0.06F, 0.42F}, 0.012F),
                   place * moved(x, 0.02F, 0.0F), 303U);
        std::vector<vec2> scroll;
        for (int i = 0; i <= 16; ++i) {
            const float t = static_cast<float>(i) / 16.0F;
            scroll.emplace_back(0.19F - 0.06F * std::sin(glm::pi<float>() * t) +
                                    0.012F * std::sin(4.0F * glm::pi<float>() * t),
                                0.045F + 0.34F * t);
        }
        for (int i = 16; i >= 0; --i)
            scroll.emplace_back(-scroll[static_cast<std::size_t>(i)].x,
                                scroll[static_cast<std::size_t>(i)].y);
        garden.put(Surface::kStone, extrude(scroll, -0.065F, 0.065F, 0.5F),
                   place * moved(x, 0.0F, 0.0F) * about_y(glm::half_pi<float>()), 304U);
        garden.put(Surface::kStone, bevelled_box({0.15F, 0.42F, 0.13F}, 0.012F),
                   place * moved(x * 1.21F, 0.68F, -0.16F), 305U);
        garden.put(Surface::kStone, bevelled_box({0.14F, 0.07F, 0.38F}, 0.02F),
                   place * moved(x * 1.21F, 0.69F, 0.02F), 306U);
        garden.put(Surface::kStone,
                   revolve(std::array<vec2, 8>{{{0.0F, 0.0F},
                                                {0.055F, 0.0F},
                                                {0.05F, 0.03F},
                                                {0.035F, 0.06F},
                                                {0.052F, 0.12F},
                                                {0.035F, 0.165F},
                                                {0.05F, 0.18F},
                                                {0.0F, 0.185F}}},
                           24),
                   place * moved(x * 1.21F, 0.475F, 0.15F), 307U);
    }
    garden.put(Surface::kStone, bevelled_box({1.50F, 0.07F, 0.15F}, 0.02F),
               place * moved(0.0F, 0.90F, -0.16F), 308U);
    const std::array<vec2, 11> baluster{{{0.0F, 0.0F},
                                         {0.045F, 0.0F},
                                         {0.045F, 0.03F},
                                         {0.028F, 0.045F},
                                         {0.030F, 0.07F},
                                         {0.050F, 0.14F},
                                         {0.046F, 0.19F},
                                         {0.024F, 0.29F},
                                         {0.036F, 0.33F},
                                         {0.044F, 0.345F},
                                         {0.044F, 0.39F}}};
    for (int i = 0; i < 8; ++i) {
        garden.put(Surface::kStone, revolve(baluster, 24),
                   place * moved(-0.525F + 0.15F * static_cast<float>(i), 0.4775F, -0.16F),
                   309U + static_cast<std::uint32_t>(i));
    }
}

void put_pedestal(Assembly& garden, const glm::mat4& place) {
    garden.put(Surface::kStone, bevelled_box({0.56F, 0.10F, 0.56F}, 0.015F),
               place * moved(0.0F, 0.05F, 0.0F), 331U);
    garden.put(Surface::kStone, bevelled_box({0.48F, 0.06F, 0.48F}, 0.02F),
               place * moved(0.0F, 0.13F, 0.0F), 332U);
    garden.put(Surface::kStone, bevelled_box({0.42F, 0.50F, 0.42F}, 0.01F),
               place * moved(0.0F, 0.40F, 0.0F), 333U);
    for (int i = 0; i < 4; ++i) {
        const glm::mat4 side = place * about_y(glm::half_pi<float>() * static_cast<float>(i));
        for (const float edge : {-1.0F, 1.0F}) {
            garden.put(Surface::kStone, bevelled_box({0.03F, 0.40F, 0.016F}, 0.005F),
                       side * moved(edge * 0.15F, 0.41F, 0.213F), 334U);
            garden.put(Surface::kStone, bevelled_box({0.272F, 0.03F, 0.015F}, 0.005F),
                       side * moved(0.0F, 0.41F + edge * 0.185F, 0.213F), 335U);
        }
    }
    garden.put(Surface::kStone, bevelled_box({0.49F, 0.045F, 0.49F}, 0.014F),
               place * moved(0.0F, 0.67F, 0.0F), 336U);
    garden.put(Surface::kStone, bevelled_box({0.55F, 0.05F, 0.55F}, 0.018F),
               place * moved(0.0F, 0.715F, 0.0F), 337U);
}

void put_bowl(Assembly& garden, const glm::mat4& urn) {
    garden.put(Surface::kStone, bevelled_box({0.24F, 0.04F, 0.24F}, 0.008F),
               urn * moved(0.0F, 0.02F, 0.0F), 338U);
    const std::array<vec2, 9> foot{{{0.0F, 0.04F},
                                    {0.11F, 0.04F},
                                    {0.115F, 0.055F},
                                    {0.10F, 0.07F},
                                    {0.055F, 0.09F},
                                    {0.045F, 0.12F},
                                    {0.065F, 0.14F},
                                    {0.068F, 0.15F},
                                    {0.05F, 0.16F}}};
    garden.put(Surface::kStone, revolve(foot, 40), urn, 339U);
    // The bowl: gadroons below, a plain band, a rolled rim.
    PatchOptions options;
    options.columns = 192;
    options.rows = 30;
    options.closed_u = true;
    options.size_m = {1.4F, 0.4F};
    const Mesh bowl = patch(options, [](float u, float v) {
        const float a = glm::two_pi<float>() * u;
        float r = 0.055F + 0.175F * std::sin(glm::half_pi<float>() * std::min(1.0F, v / 0.55F));
        if (v > 0.55F) r = 0.23F - 0.03F * std::sin(glm::pi<float>() * (v - 0.55F) / 0.35F);
        if (v > 0.88F) r += 0.05F * glm::smoothstep(0.88F, 0.97F, v);
        const float lobes = glm::smoothstep(0.0F, 0.12F, v) * glm::smoothstep(0.56F, 0.46F, v);
        r += lobes * (0.018F * std::abs(std::sin(12.0F * a)) - 0.008F);
        return vec3(r * std::sin(a), 0.15F + 0.34F * v, r * std::cos(a));
    });
    garden.put(Surface::kStone, bowl, urn, 340U);
    const std::array<vec2, 7> lip{{{0.270F, 0.480F},
                                   {0.302F, 0.486F},
                                   {0.308F, 0.498F},
                                   {0.298F, 0.51F},
                                   {0.235F, 0.51F},
                                   {0.20F, 0.49F},
                                   {0.19F, 0.46F}}};
    garden.put(Surface::kStone, revolve(lip, 64), urn, 341U);
    const std::array<vec2, 2> earth{{{0.20F, 0.47F}, {0.0F, 0.485F}}};
    garden.put(Surface::kSoil, revolve(earth, 32), urn, 342U);
    for (const float side : {-1.0F, 1.0F}) {
        const std::array<vec3, 5> handle{{{side * 0.20F, 0.28F, 0.0F},
                                          {side * 0.31F, 0.27F, 0.0F},
                                          {side * 0.33F, 0.40F, 0.0F},
                                          {side * 0.27F, 0.46F, 0.0F},
                                          {side * 0.22F, 0.43F, 0.0F}}};
        garden.put(Surface::kStone, pipe(handle, 0.06F, 0.017F, 12), urn, 343U);
    }
}

/// Trailing ivy and an upright clump.
void put_plants(Assembly& garden, const glm::mat4& urn) {
    base::Random random(345);
    for (int i = 0; i < 30; ++i) {
        const float turn = draw(random, 0.0F, 6.2832F);
        const float drop = draw(random, 0.08F, 0.55F);
        const int leaves = 3 + static_cast<int>(drop * 22.0F);
        for (int k = 0; k < leaves; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(leaves);
            const float out =
                0.20F + 0.10F * std::min(1.0F, 4.0F * t) + draw(random, -0.015F, 0.03F);
            const float size = draw(random, 0.045F, 0.075F);
            garden.put_mapped(Surface::kIvy, card(size, size, 0.6F, 0.25F, 2),
                              urn * about_y(turn + draw(random, -0.1F, 0.1F) + 0.4F * t) *
                                  moved(0.0F, 0.52F - drop * t * t, out) *
                                  about_y(draw(random, -0.6F, 0.6F)) *
                                  about_x(draw(random, 1.6F, 2.7F)),
                              shade_of(static_cast<std::uint32_t>(100 * i + k), 0.4F));
        }
    }
    for (int i = 0; i < 46; ++i) {
        const float length = draw(random, 0.22F, 0.46F);
        garden.put_mapped(
            Surface::kGrass, card(length, 0.32F * length, draw(random, 0.5F, 1.5F), 0.1F, 5),
            urn * about_y(draw(random, 0.0F, 6.2832F)) *
                moved(0.0F, 0.47F, draw(random, 0.0F, 0.09F)) * about_x(draw(random, 0.0F, 0.5F)),
            shade_of(static_cast<std::uint32_t>(i) + 900U, 0.35F));
    }
    for (int i = 0; i < 90; ++i) {
        const float turn = draw(random, 0.0F, 6.2832F);
        const float r = 0.17F * std::sqrt(draw(random, 0.0F, 1.0F));
        garden.put_mapped(
            Surface::kTwig, card(draw(random, 0.10F, 0.18F), 0.12F, 0.8F, 0.25F, 3),
            urn * about_y(turn) * moved(0.0F, 0.475F, r) * about_x(draw(random, 0.1F, 1.1F)),
            shade_of(static_cast<std::uint32_t>(i) + 1900U, 0.35F));
    }
}

/// A fluted urn with handles on a panelled pedestal, planted.
void put_urn(Assembly& garden, const glm::mat4& place) {
    put_pedestal(garden, place);
    const glm::mat4 urn = place * moved(0.0F, 0.74F, 0.0F);
    put_bowl(garden, urn);
    put_plants(garden, urn);
}

Mesh pot_shape() {
    return revolve(std::array<vec2, 10>{{{0.0F, 0.0F},
                                         {0.085F, 0.0F},
                                         {0.09F, 0.006F},
                                         {0.118F, 0.17F},
                                         {0.132F, 0.172F},
                                         {0.137F, 0.22F},
                                         {0.130F, 0.225F},
                                         {0.120F, 0.22F},
                                         {0.088F, 0.012F},
                                         {0.0F, 0.010F}}},
                   40);
}

void put_pots(Assembly& garden) {
    const Mesh pot = pot_shape();
    const float x = 1.55F;
    const float z = -1.02F;
    garden.put(Surface::kClay, pot, moved(x, 0.008F, z), 361U);
    garden.put(
        Surface::kClay, pot,
        moved(x + 0.006F, 0.075F, z) * about_z(0.02F) * glm::scale(glm::mat4(1.0F), vec3(0.96F)),
        362U, vec3(0.85F));
    garden.put(Surface::kClay, pot,
               moved(x + 0.30F, 0.13F, z + 0.16F) * about_y(0.8F) * about_z(1.52F) *
                   moved(0.0F, -0.11F, 0.0F),
               363U, vec3(0.92F));
    // One that is planted.
    const glm::mat4 place =
        moved(x + 0.14F, 0.006F, z - 0.16F) * glm::scale(glm::mat4(1.0F), vec3(1.25F));
    garden.put(Surface::kClay, pot, place, 364U, vec3(0.8F));
    garden.put(Surface::kSoil, revolve(std::array<vec2, 2>{{{0.120F, 0.195F}, {0.0F, 0.205F}}}, 28),
               place, 365U);
    base::Random random(366);
    for (int i = 0; i < 90; ++i) {
        const float turn = draw(random, 0.0F, 6.2832F);
        garden.put_mapped(
            Surface::kTwig,
            card(draw(random, 0.10F, 0.20F), 0.11F, draw(random, 0.4F, 1.3F), 0.25F, 3),
            place * about_y(turn) * moved(0.0F, 0.19F, draw(random, 0.0F, 0.09F)) *
                about_x(draw(random, 0.0F, 1.0F)),
            shade_of(static_cast<std::uint32_t>(i) + 3000U, 0.35F));
    }
}

/// A galvanised watering can with spout, rose and two handles.
void put_can(Assembly& garden, const glm::mat4& place) {
    const std::array<vec2, 10> body{{{0.0F, 0.0F},
                                     {0.115F, 0.0F},
                                     {0.118F, 0.006F},
                                     {0.112F, 0.014F},
                                     {0.112F, 0.235F},
                                     {0.118F, 0.243F},
                                     {0.112F, 0.25F},
                                     {0.06F, 0.285F},
                                     {0.056F, 0.287F},
                                     {0.054F, 0.275F}}};
    garden.put(Surface::kZinc, revolve(body, 44), place, 381U);
    for (const float y : {0.075F, 0.17F})
        garden.put(Surface::kZinc, ring(0.113F, 0.0035F, 44, 6), place * moved(0.0F, y, 0.0F),
                   382U);
    const std::array<vec3, 3> spout{
        {{0.10F, 0.05F, 0.0F}, {0.20F, 0.12F, 0.0F}, {0.36F, 0.31F, 0.0F}}};
    garden.put(Surface::kZinc, pipe(spout, 0.08F, 0.016F, 14), place, 383U);
    garden.put(
        Surface::kZinc,
        revolve(
            std::array<vec2, 5>{
                {{0.0F, 0.0F}, {0.016F, 0.0F}, {0.045F, 0.055F}, {0.045F, 0.06F}, {0.0F, 0.068F}}},
            28),
        place * moved(0.35F, 0.298F, 0.0F) * about_z(-0.87F), 384U, vec3(0.8F, 0.7F, 0.5F));
    const std::array<vec3, 5> handle{{{-0.03F, 0.27F, 0.0F},
                                      {-0.02F, 0.37F, 0.0F},
                                      {-0.14F, 0.38F, 0.0F},
                                      {-0.22F, 0.25F, 0.0F},
                                      {-0.105F, 0.10F, 0.0F}}};
    garden.put(Surface::kZinc, pipe(handle, 0.07F, 0.009F, 12), place, 385U);
    garden.put(Surface::kZinc, rod({0.09F, 0.24F, 0.0F}, {0.27F, 0.205F, 0.0F}, 0.005F, 8), place,
               386U);
}

/// A spade that leans on the wall.
void put_spade(Assembly& garden, const glm::mat4& place) {
    garden.put(Surface::kWood, rod({0.0F, 0.28F, 0.0F}, {0.0F, 1.02F, 0.0F}, 0.016F, 14), place,
               391U);
    const std::array<vec3, 5> grip{{{0.0F, 1.0F, 0.0F},
                                    {0.055F, 1.05F, 0.0F},
                                    {0.055F, 1.13F, 0.0F},
                                    {-0.055F, 1.13F, 0.0F},
                                    {-0.055F, 1.05F, 0.0F}}};
    garden.put(Surface::kWood, pipe(grip, 0.02F, 0.011F, 10), place, 392U);
    garden.put(Surface::kWood, rod({-0.055F, 1.05F, 0.0F}, {0.0F, 1.0F, 0.0F}, 0.011F, 10), place,
               392U);
    PatchOptions options;
    options.columns = 14;
    options.rows = 12;
    const auto blade = [](float offset) {
        return [offset](float u, float v) {
            const float x = (u - 0.5F) * 0.19F * (1.0F - 0.25F * (1.0F - v) * (1.0F - v));
            return vec3(x, 0.30F * v, offset + 2.6F * x * x + 0.02F * v * (1.0F - v));
        };
    };
    garden.put(Surface::kZinc, patch(options, blade(0.002F)), place, 393U,
               vec3(0.55F, 0.5F, 0.45F));
    Mesh back = patch(options, [&](float u, float v) { return blade(-0.002F)(1.0F - u, v); });
    garden.put(Surface::kZinc, back, place, 394U, vec3(0.55F, 0.5F, 0.45F));
    garden.put(Surface::kZinc, rod({0.0F, 0.24F, 0.002F}, {0.0F, 0.42F, 0.0F}, 0.02F, 14), place,
               395U, vec3(0.6F));
}

}  // namespace

void build_ornaments(Assembly& garden) {
    put_bench(garden, moved(0.02F, 0.0F, -0.86F) * about_y(0.05F));
    put_urn(garden, moved(-2.25F, 0.0F, -0.88F) * about_y(0.35F));
    put_pots(garden);
    put_can(garden, moved(-1.22F, 0.006F, -0.62F) * about_y(0.6F));
    put_spade(garden, moved(-3.3F, 0.0F, -2.32F) * about_x(-0.20F));
}

}  // namespace obscura::stimuli::garden
