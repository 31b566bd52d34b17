// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "stimuli/scenes/room/parts.h"

namespace obscura::stimuli::room {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

/// A board whose grain runs along its longest side.
void put_board(Assembly& study, const vec3& size, const glm::mat4& place, std::uint32_t seed,
               float bevel = 0.003F) {
    glm::mat4 turn(1.0F);
    vec3 own = size;
    if (size.x >= size.y && size.x >= size.z) {
        turn = about_z(-glm::half_pi<float>());
        own = {size.y, size.x, size.z};
    } else if (size.z >= size.y) {
        turn = about_x(glm::half_pi<float>());
        own = {size.x, size.z, size.y};
    }
    study.put(Surface::kWood, bevelled_box(own, bevel), place * turn, seed, shade_of(seed, 0.18F));
}

/// A bar as sweep() and rod() give it, with the grain along it instead of around.
Mesh along_grain(Mesh bar) {
    for (renderer::Vertex& vertex : bar.vertices) std::swap(vertex.uv.x, vertex.uv.y);
    make_tangents(bar);
    return bar;
}

void put_knob(Assembly& study, const glm::mat4& place) {
    const std::array<vec2, 7> knob{{{0.0F, 0.0F},
                                    {0.010F, 0.0F},
                                    {0.006F, 0.008F},
                                    {0.006F, 0.014F},
                                    {0.014F, 0.020F},
                                    {0.012F, 0.029F},
                                    {0.0F, 0.032F}}};
    study.put(Surface::kMetal, revolve(knob, 18), place * lie_along_z(), 200U,
              vec3(0.9F, 0.72F, 0.45F));
}

void put_desk(Assembly& study) {
    constexpr float kFrom = -1.98F;
    constexpr float kTo = -0.18F;
    constexpr float kNear = -1.20F;
    constexpr float kFar = -1.96F;
    const float x = 0.5F * (kFrom + kTo);
    const float z = 0.5F * (kNear + kFar);
    for (int i = 0; i < 4; ++i) {
        const float depth = (kNear - kFar) / 4.0F;
        put_board(study, {kTo - kFrom, 0.032F, depth},
                  moved(x, kDeskTop - 0.016F, kFar + depth * (static_cast<float>(i) + 0.5F)),
                  210U + static_cast<std::uint32_t>(i), 0.0012F);
    }
    put_board(study, {kTo - kFrom - 0.08F, 0.085F, 0.02F},
              moved(x, kDeskTop - 0.074F, kNear - 0.06F), 215U);
    put_board(study, {kTo - kFrom - 0.08F, 0.30F, 0.018F}, moved(x, kDeskTop - 0.18F, kFar + 0.04F),
              216U);
    for (const float at_x : {kFrom + 0.06F, kTo - 0.06F}) {
        put_board(study, {0.02F, 0.085F, kNear - kFar - 0.1F}, moved(at_x, kDeskTop - 0.074F, z),
                  217U);
        for (const float at_z : {kNear - 0.06F, kFar + 0.06F}) {
            const std::array<vec2, 10> leg{{{0.0F, 0.0F},
                                            {0.018F, 0.0F},
                                            {0.022F, 0.02F},
                                            {0.016F, 0.05F},
                                            {0.026F, 0.30F},
                                            {0.030F, 0.52F},
                                            {0.024F, 0.55F},
                                            {0.032F, 0.57F},
                                            {0.032F, 0.60F},
                                            {0.0F, 0.60F}}};
            study.put(Surface::kWood, revolve(leg, 22), moved(at_x, 0.0F, at_z), 218U);
            study.put(Surface::kWood, bevelled_box({0.064F, 0.115F, 0.064F}, 0.004F),
                      moved(at_x, 0.652F, at_z), 219U);
        }
    }
    // A chest of three drawers under its right end.
    const glm::mat4 chest = moved(kTo - 0.34F, 0.0F, z + 0.016F);
    for (const float side : {-0.2F, 0.2F})
        put_board(study, {0.018F, 0.58F, 0.62F}, chest * moved(side, 0.35F, 0.0F), 220U);
    put_board(study, {0.39F, 0.018F, 0.614F}, chest * moved(0.0F, 0.069F, 0.0F), 221U);
    put_board(study, {0.39F, 0.575F, 0.010F}, chest * moved(0.0F, 0.35F, -0.30F), 228U);
    for (int i = 0; i < 3; ++i) {
        const float y = 0.165F + 0.19F * static_cast<float>(i);
        const float out = i == 1 ? 0.07F : 0.0F;  // one is not quite shut
        put_board(study, {0.375F, 0.178F, 0.02F}, chest * moved(0.0F, y, 0.315F + out),
                  222U + static_cast<std::uint32_t>(i), 0.005F);
        put_board(study, {0.30F, 0.11F, 0.008F}, chest * moved(0.0F, y, 0.327F + out), 226U,
                  0.004F);
        // Its box, on runners that the chest's sides carry.
        for (const float side : {-1.0F, 1.0F}) {
            put_board(study, {0.012F, 0.12F, 0.52F}, chest * moved(side * 0.18F, y, 0.05F + out),
                      227U);
            put_board(study, {0.016F, 0.012F, 0.56F},
                      chest * moved(side * 0.185F, y - 0.066F, -0.01F), 229U);
        }
        put_board(study, {0.352F, 0.007F, 0.51F}, chest * moved(0.0F, y - 0.05F, 0.05F + out),
                  230U);
        put_board(study, {0.352F, 0.11F, 0.012F}, chest * moved(0.0F, y + 0.004F, -0.20F + out),
                  231U);
        put_knob(study, chest * moved(0.0F, y, 0.330F + out));
    }
}

void put_shelves(Assembly& study) {
    const float middle = 0.5F * (kShelfLeft + kShelfRight);
    const float width = kShelfRight - kShelfLeft;
    const float z = kBack + 0.5F * kShelfDepth + 0.02F;
    const float high = 2.17F;
    constexpr float kUpright = 0.025F;
    for (const float x :
         {kShelfLeft - 0.5F * kUpright, kShelfMiddle, kShelfRight + 0.5F * kUpright}) {
        put_board(study, {kUpright, high, kShelfDepth + 0.02F}, moved(x, 0.5F * high, z),
                  240U + static_cast<std::uint32_t>(10.0F * x));
    }
    // Shelves and the boards of the back are let into what they meet, so that nothing shows through
    // a joint; a sheet behind the boards closes those between them.
    constexpr float kLetIn = 0.004F;
    std::uint32_t seed = 260;
    for (const float y : kShelf_m) {
        for (const float half : {-1.0F, 1.0F}) {
            const float x = middle + half * (0.25F * width + 0.25F * kUpright);
            put_board(study, {0.5F * (width - kUpright) + 2.0F * kLetIn, 0.022F, kShelfDepth},
                      moved(x, y - 0.011F, z), seed++);
        }
    }
    for (int i = 0; i < 12; ++i) {
        put_board(study, {width / 12.0F - 0.0015F, high + kLetIn, 0.010F},
                  moved(kShelfLeft + width * (static_cast<float>(i) + 0.5F) / 12.0F,
                        0.5F * (high + kLetIn), kBack + 0.0165F),
                  seed++, 0.002F);
    }
    put_board(study, {width + kUpright, high + kLetIn, 0.008F},
              moved(middle, 0.5F * (high + kLetIn), kBack + 0.009F), seed++, 0.001F);
    put_board(study, {width + 0.08F, 0.085F, 0.022F}, moved(middle, 0.042F, z + 0.5F * kShelfDepth),
              seed++);
    // A stepped cornice.
    put_board(study, {width + 0.07F, 0.03F, kShelfDepth + 0.05F},
              moved(middle, high + 0.015F, z + 0.01F), seed++);
    put_board(study, {width + 0.11F, 0.022F, kShelfDepth + 0.08F},
              moved(middle, high + 0.041F, z + 0.015F), seed++, 0.006F);
    put_board(study, {width + 0.15F, 0.022F, kShelfDepth + 0.11F},
              moved(middle, high + 0.063F, z + 0.02F), seed++, 0.008F);
}

/// A chair with turned legs, stretchers, and a back of spindles under a curved rail.
void put_chair(Assembly& study, const glm::mat4& place) {
    PatchOptions options;
    options.columns = 28;
    options.rows = 28;
    options.closed_u = true;
    options.size_m = {1.4F, 0.2F};
    // The seat: a rounded slab with a hollow.
    Mesh seat = patch(options, [](float u, float v) {
        const float a = glm::two_pi<float>() * u;
        const float c = std::cos(a);
        const float s = std::sin(a);
        const float square =
            std::pow(std::pow(std::abs(c), 4.0F) + std::pow(std::abs(s), 4.0F), -0.25F);
        const float b = glm::pi<float>() * (v - 0.5F);
        const float flat = std::pow(std::cos(b), 0.22F);
        const float r = v <= 0.0F || v >= 1.0F ? 0.0F : flat;
        const float hollow = v > 0.5F ? 0.016F * glm::smoothstep(0.9F, 0.2F, r) : 0.0F;
        return vec3(0.215F * s * square * r,
                    0.45F +
                        0.017F * std::copysign(std::pow(std::abs(std::sin(b)), 0.5F), std::sin(b)) -
                        hollow,
                    0.205F * c * square * r);
    });
    project_box_uv(seat);
    study.put(Surface::kWood, seat, place, 300U);
    const auto turned = [&](const vec3& from, const vec3& to, float r) {
        const float length = glm::length(to - from);
        const std::array<vec2, 11> shape{{{0.0F, 0.0F},
                                          {0.75F * r, 0.0F},
                                          {0.8F * r, 0.12F * length},
                                          {1.15F * r, 0.3F * length},
                                          {1.25F * r, 0.42F * length},
                                          {0.85F * r, 0.5F * length},
                                          {1.3F * r, 0.53F * length},
                                          {0.85F * r, 0.56F * length},
                                          {1.2F * r, 0.7F * length},
                                          {0.8F * r, length},
                                          {0.0F, length}}};
        const vec3 y = glm::normalize(to - from);
        const vec3 x = any_perpendicular(y);
        const glm::mat4 stand(glm::vec4(x, 0.0F), glm::vec4(y, 0.0F),
                              glm::vec4(glm::cross(x, y), 0.0F), glm::vec4(from, 1.0F));
        study.put(Surface::kWood, revolve(shape, 16), place * stand, 301U);
    };
    for (const float x : {-1.0F, 1.0F}) {
        turned({x * 0.23F, 0.0F, 0.21F}, {x * 0.16F, 0.44F, 0.15F}, 0.016F);
        turned({x * 0.21F, 0.0F, -0.25F}, {x * 0.15F, 0.44F, -0.15F}, 0.016F);
        turned({x * 0.205F, 0.16F, 0.19F}, {x * 0.19F, 0.16F, -0.21F}, 0.010F);
    }
    turned({-0.2F, 0.16F, 0.0F}, {0.2F, 0.16F, 0.0F}, 0.010F);
    for (int i = 0; i < 7; ++i) {
        const float x = -0.165F + 0.055F * static_cast<float>(i);
        const float bow = 0.06F * (x / 0.17F) * (x / 0.17F);
        study.put(Surface::kWood,
                  along_grain(rod({0.9F * x, 0.46F, -0.175F + 0.6F * bow},
                                  {1.12F * x, 0.88F, -0.275F + bow}, 0.0075F, 10)),
                  place, 302U);
    }
    std::vector<vec3> rail;
    for (int i = 0; i <= 12; ++i) {
        const float x = 0.215F * (static_cast<float>(i) / 6.0F - 1.0F);
        rail.emplace_back(x, 0.90F - 0.02F * (x / 0.2F) * (x / 0.2F),
                          -0.278F + 0.065F * (x / 0.19F) * (x / 0.19F));
    }
    const std::array<vec2, 8> section{{{0.010F, -0.03F},
                                       {0.012F, 0.0F},
                                       {0.010F, 0.03F},
                                       {0.004F, 0.036F},
                                       {-0.004F, 0.036F},
                                       {-0.010F, 0.03F},
                                       {-0.012F, 0.0F},
                                       {-0.010F, -0.03F}}};
    study.put(Surface::kWood, along_grain(sweep(section, frames_along(rail, {0.0F, 1.0F, 0.0F}))),
              place, 303U);
}

/// Columns between two headers, on feet, with a valve.
void put_radiator(Assembly& study) {
    const float x = kLeft + 0.085F;
    constexpr int kColumns = 15;
    constexpr float kStep = 0.062F;
    const float first = -0.52F - 0.5F * kStep * kColumns;
    for (int i = 0; i < kColumns; ++i) {
        const float z = first + kStep * (static_cast<float>(i) + 0.5F);
        for (const float off : {-0.042F, 0.0F, 0.042F}) {
            const std::array<vec3, 6> tube{{{x + 0.4F * off, 0.15F, z},
                                            {x + off, 0.17F, z},
                                            {x + off, 0.3F, z},
                                            {x + off, 0.55F, z},
                                            {x + off, 0.68F, z},
                                            {x + 0.4F * off, 0.70F, z}}};
            std::vector<vec2> oval;
            for (const vec2& point : circle(1.0F, 12))
                oval.emplace_back(0.0165F * point.x, 0.020F * point.y);
            study.put(Surface::kLacquer,
                      sweep(oval, frames_along(rounded_path(tube, 0.03F, 3), {0.0F, 0.0F, 1.0F})),
                      glm::mat4(1.0F), 320U);
        }
        for (const float y : {0.155F, 0.695F}) {
            study.put(Surface::kLacquer, cushion({0.115F, 0.058F, kStep - 0.003F}, 0.004F),
                      moved(x, y, z), 321U);
        }
    }
    const float end = first + kStep * kColumns;
    for (const float z : {first + 0.03F, end - 0.03F}) {
        study.put(Surface::kLacquer, bevelled_box({0.10F, 0.13F, 0.03F}, 0.01F),
                  moved(x, 0.065F, z), 322U);
    }
    const std::array<vec3, 3> supply{
        {{x, 0.155F, end}, {x, 0.155F, end + 0.07F}, {x, -0.01F, end + 0.07F}}};
    study.put(Surface::kMetal, pipe(supply, 0.03F, 0.009F, 12), glm::mat4(1.0F), 323U);
    const std::array<vec2, 6> valve{{{0.0F, 0.0F},
                                     {0.016F, 0.0F},
                                     {0.022F, 0.015F},
                                     {0.022F, 0.05F},
                                     {0.018F, 0.058F},
                                     {0.0F, 0.06F}}};
    study.put(Surface::kLacquer, revolve(valve, 20), moved(x, 0.165F, end + 0.06F), 324U);
}

}  // namespace

void build_furniture(Assembly& study) {
    put_desk(study);
    put_shelves(study);
    put_chair(study, moved(-0.92F, 0.012F, -0.86F) * about_y(2.72F));
    put_radiator(study);
    // A low table beside the armchair.
    const glm::mat4 table = moved(-0.98F, 0.012F, 1.28F);
    study.put(Surface::kWood,
              revolve(std::array<vec2, 6>{{{0.0F, 0.46F},
                                           {0.22F, 0.46F},
                                           {0.235F, 0.47F},
                                           {0.235F, 0.48F},
                                           {0.225F, 0.488F},
                                           {0.0F, 0.488F}}},
                      48),
              table, 330U);
    for (const glm::mat4& spot : around(3, 0.15F)) {
        study.put(Surface::kWood,
                  along_grain(rod({0.0F, 0.0F, 0.05F}, {0.0F, 0.465F, -0.03F}, 0.014F, 14)),
                  table * spot, 331U);
    }
}

}  // namespace obscura::stimuli::room
