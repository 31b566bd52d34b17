// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "stimuli/scenes/machine/parts.h"

namespace obscura::stimuli::machine {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

void put_bolt(Assembly& hall, const glm::mat4& place, float size_m, std::uint32_t seed) {
    hall.put(Surface::kSteel, bolt(size_m), place * about_y(static_cast<float>(seed)), seed,
             shade_of(seed, 0.4F));
}

void put_flange(Assembly& hall, Surface surface, const glm::mat4& place, float radius_m,
                float thick_m, int bolts, float bolt_m, const vec3& tint) {
    const float edge = 0.12F * thick_m;
    const std::array<vec2, 6> profile{{{0.0F, 0.0F},
                                       {radius_m - edge, 0.0F},
                                       {radius_m, edge},
                                       {radius_m, thick_m - edge},
                                       {radius_m - edge, thick_m},
                                       {0.0F, thick_m}}};
    hall.put(surface, revolve(profile, 36), place, 11U, tint);
    const Mesh one = bolt(bolt_m);
    std::uint32_t seed = 20;
    for (const glm::mat4& spot : around(bolts, radius_m - 1.5F * bolt_m, 0.2F)) {
        ++seed;
        hall.put(Surface::kSteel, one,
                 place * spot * moved(0.0F, thick_m, 0.0F) * about_y(static_cast<float>(seed)),
                 seed, shade_of(seed, 0.4F));
    }
}

void put_joint(Assembly& hall, Surface surface, const glm::mat4& place, float pipe_m,
               const vec3& tint) {
    const float radius = 1.75F * pipe_m + 0.012F;
    const float thick = 0.012F + 0.1F * pipe_m;
    const float size = 0.006F + 0.07F * pipe_m;
    put_flange(hall, surface, place * moved(0.0F, 0.0012F, 0.0F), radius, thick, 8, size, tint);
    put_flange(hall, surface, place * moved(0.0F, -0.0012F, 0.0F) * about_x(glm::pi<float>()),
               radius, thick, 8, size, tint);
}

void put_hand_wheel(Assembly& hall, const glm::mat4& place, float radius_m, const vec3& tint) {
    hall.put(Surface::kEnamel, ring(radius_m, 0.085F * radius_m, 32), place, 41U, tint);
    const std::array<vec2, 6> hub{{{0.0F, -0.12F * radius_m},
                                   {0.16F * radius_m, -0.12F * radius_m},
                                   {0.2F * radius_m, 0.0F},
                                   {0.16F * radius_m, 0.14F * radius_m},
                                   {0.08F * radius_m, 0.2F * radius_m},
                                   {0.0F, 0.2F * radius_m}}};
    hall.put(Surface::kEnamel, revolve(hub, 16), place, 42U, tint);
    for (const glm::mat4& spot : around(5, 0.0F)) {
        const std::array<vec3, 3> spoke{{{0.0F, 0.02F * radius_m, 0.1F * radius_m},
                                         {0.0F, -0.08F * radius_m, 0.55F * radius_m},
                                         {0.0F, 0.0F, 0.98F * radius_m}}};
        hall.put(Surface::kEnamel, pipe(spoke, 0.3F * radius_m, 0.055F * radius_m, 8), place * spot,
                 43U, tint);
    }
}

void put_valve(Assembly& hall, const glm::mat4& place, float pipe_m) {
    const float r = pipe_m;
    const std::array<vec2, 10> body{{{0.0F, -2.4F * r},
                                     {1.0F * r, -2.4F * r},
                                     {1.05F * r, -1.6F * r},
                                     {1.5F * r, -0.9F * r},
                                     {1.65F * r, 0.0F},
                                     {1.5F * r, 0.9F * r},
                                     {1.05F * r, 1.6F * r},
                                     {1.0F * r, 2.4F * r},
                                     {0.5F * r, 2.4F * r},
                                     {0.0F, 2.4F * r}}};
    hall.put(Surface::kEnamel, revolve(body, 24, 1.0F), place, 51U, kGreen);
    put_joint(hall, Surface::kCast, place * moved(0.0F, 2.4F * r, 0.0F), r);
    put_joint(hall, Surface::kCast, place * moved(0.0F, -2.4F * r, 0.0F), r);
    const glm::mat4 out = place * about_x(glm::half_pi<float>());  // +Y of the part to +Z
    const std::array<vec2, 6> bonnet{{{0.0F, 0.6F * r},
                                      {1.2F * r, 0.6F * r},
                                      {1.1F * r, 1.9F * r},
                                      {0.75F * r, 2.4F * r},
                                      {0.55F * r, 3.1F * r},
                                      {0.0F, 3.1F * r}}};
    hall.put(Surface::kEnamel, revolve(bonnet, 20), out, 52U, kGreen);
    put_flange(hall, Surface::kCast, out * moved(0.0F, 1.8F * r, 0.0F), 1.6F * r, 0.32F * r, 6,
               0.16F * r);
    hall.put(Surface::kSteel, rod({0.0F, 3.0F * r, 0.0F}, {0.0F, 5.2F * r, 0.0F}, 0.22F * r), out,
             53U);
    hall.put(Surface::kBrass, bolt(0.34F * r), out * moved(0.0F, 3.1F * r, 0.0F), 54U);
    put_hand_wheel(hall, out * moved(0.0F, 4.7F * r, 0.0F), 1.9F * r, kRed);
}

void put_gauge(Assembly& hall, const glm::mat4& place, float radius_m) {
    const float r = radius_m;
    const glm::mat4 out = place * about_x(glm::half_pi<float>());
    const std::array<vec2, 9> shell{{{0.0F, 0.0F},
                                     {0.9F * r, 0.0F},
                                     {1.0F * r, 0.08F * r},
                                     {1.0F * r, 0.42F * r},
                                     {1.1F * r, 0.44F * r},
                                     {1.1F * r, 0.56F * r},
                                     {1.0F * r, 0.6F * r},
                                     {0.93F * r, 0.56F * r},
                                     {0.93F * r, 0.46F * r}}};
    hall.put(Surface::kBrass, revolve(shell, 28), out, 61U);
    // The face hangs a little behind the glassless rim.
    Mesh face;
    const std::array<vec2, 2> disc{{{0.95F * r, 0.0F}, {0.0F, 0.0F}}};
    face = revolve(disc, 28);
    for (renderer::Vertex& vertex : face.vertices) {
        vertex.uv =
            vec2(0.5F) + 0.5F * vec2(vertex.position_m.x, vertex.position_m.z) / (0.95F * r);
    }
    make_tangents(face);
    hall.put_mapped(Surface::kDial, face, out * moved(0.0F, 0.47F * r, 0.0F));
}

void put_oil_cup(Assembly& hall, const glm::mat4& place, float size_m) {
    const float s = size_m;
    const std::array<vec2, 12> cup{{{0.0F, 0.0F},
                                    {0.25F * s, 0.0F},
                                    {0.25F * s, 0.3F * s},
                                    {0.2F * s, 0.35F * s},
                                    {0.2F * s, 0.5F * s},
                                    {0.55F * s, 0.6F * s},
                                    {0.6F * s, 0.7F * s},
                                    {0.6F * s, 1.4F * s},
                                    {0.66F * s, 1.45F * s},
                                    {0.62F * s, 1.6F * s},
                                    {0.2F * s, 1.85F * s},
                                    {0.0F, 1.9F * s}}};
    hall.put(Surface::kBrass, revolve(cup, 20), place, 71U);
}

}  // namespace obscura::stimuli::machine
