// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "stimuli/scenes/machine/parts.h"

namespace obscura::stimuli::machine {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kFace = 0.085F;  ///< width of the teeth

/// The outline of a gear with trapezoidal teeth whose flanks are rounded at the foot; the first
/// tooth's middle is at `first_rad` from +x. Addendum 1, dedendum 1.25 modules.
std::vector<vec2> gear_outline(int teeth, float first_rad) {
    const float pitch = 0.5F * kTooth * static_cast<float>(teeth);
    const float tip = pitch + kTooth;
    const float root = pitch - 1.25F * kTooth;
    const float step = glm::two_pi<float>() / static_cast<float>(teeth);
    // Half angles of a tooth from its foot to its tip, in steps, with the radii there.
    const std::array<vec2, 5> flank{{{0.335F, root},
                                     {0.295F, root + 0.35F * kTooth},
                                     {0.232F, pitch},
                                     {0.165F, pitch + 0.6F * kTooth},
                                     {0.115F, tip}}};
    std::vector<vec2> outline;
    for (int i = 0; i < teeth; ++i) {
        const float middle = first_rad + step * static_cast<float>(i);
        const auto add = [&](float part, float radius) {
            const float a = middle + part * step;
            outline.emplace_back(radius * std::cos(a), radius * std::sin(a));
        };
        for (const vec2& point : flank) add(-point.x, point.y);
        for (std::size_t k = flank.size(); k-- > 0;) add(flank[k].x, flank[k].y);
    }
    return outline;
}

/// A ring with teeth outside and a round inside: the teeth's sweep, the bore, and both faces.
Mesh toothed_ring(int teeth, float first_rad, float bore_m) {
    const std::vector<vec2> outline = gear_outline(teeth, first_rad);
    const float h = 0.5F * kFace;
    SweepOptions open;
    open.caps = false;
    open.crease_rad = 0.45F;
    const std::array<ProfileFrame, 4> frames{
        ProfileFrame{{0.0F, 0.0F, -h}}, ProfileFrame{{0.0F, 0.0F, -0.3F * h}},
        ProfileFrame{{0.0F, 0.0F, 0.3F * h}}, ProfileFrame{{0.0F, 0.0F, h}}};
    Mesh whole = sweep(outline, frames, open);
    // Faces between the outline and the bore.
    for (const float side : {-1.0F, 1.0F}) {
        Mesh face;
        const auto count = static_cast<std::uint32_t>(outline.size());
        for (const vec2& point : outline) {
            const vec2 inner = glm::normalize(point) * bore_m;
            for (const vec2& p : {point, inner}) {
                renderer::Vertex vertex;
                vertex.position_m = vec3(p, side * h);
                vertex.normal = vec3(0.0F, 0.0F, side);
                vertex.uv = p;
                face.vertices.push_back(vertex);
            }
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t a = 2 * i;
            const std::uint32_t b = 2 * ((i + 1) % count);
            if (side > 0.0F) {
                face.indices.insert(face.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
            } else {
                face.indices.insert(face.indices.end(), {a, b + 1, b, a, a + 1, b + 1});
            }
        }
        make_tangents(face);
        append(whole, face);
    }
    // The bore has the faces' own corners, or light would come through between them.
    std::vector<vec2> bore;
    for (const vec2& point : outline) bore.push_back(glm::normalize(point) * bore_m);
    std::reverse(bore.begin(), bore.end());
    append(whole, sweep(bore, frames, open));
    return whole;
}

void put_wheel(Assembly& hall) {
    const glm::mat4 place = moved(kCrankX, kAxis, kGearZ);
    const float pitch = 0.5F * kTooth * kWheelTeeth;
    const float bore = pitch - 0.062F;
    hall.put(Surface::kCast, toothed_ring(kWheelTeeth, 0.0F, bore), place, 401U);
    // A rim, a web with five arms and a keyed hub.
    const glm::mat4 axis = place * lie_along_z();
    const std::array<vec2, 6> hub{{{0.0F, -0.065F},
                                   {0.095F, -0.065F},
                                   {0.105F, -0.05F},
                                   {0.105F, 0.05F},
                                   {0.095F, 0.065F},
                                   {0.0F, 0.065F}}};
    hall.put(Surface::kCast, revolve(hub, 36), axis, 402U);
    for (int i = 0; i < 5; ++i) {
        const glm::mat4 arm =
            place * about_z(0.3F + glm::two_pi<float>() * static_cast<float>(i) / 5.0F);
        const std::array<vec2, 4> taper{
            {{0.08F, -0.05F}, {bore + 0.01F, -0.034F}, {bore + 0.01F, 0.034F}, {0.08F, 0.05F}}};
        hall.put(Surface::kCast, extrude(taper, -0.012F, 0.012F, 0.3F), arm, 403U);
        const std::array<vec2, 4> web{
            {{0.08F, -0.010F}, {bore + 0.01F, -0.008F}, {bore + 0.01F, 0.008F}, {0.08F, 0.010F}}};
        hall.put(Surface::kCast, extrude(web, -0.032F, 0.032F, 0.3F), arm, 404U);
    }
    hall.put(Surface::kSteel, bevelled_box({0.022F, 0.022F, 0.17F}, 0.003F),
             place * moved(0.0F, 0.058F, 0.0F), 405U);
    hall.put(Surface::kSteel, bevelled_box({0.03F, 0.035F, 0.02F}, 0.004F),
             place * moved(0.0F, 0.058F, 0.088F), 406U);
}

void put_pinion(Assembly& hall) {
    const float apart = 0.5F * kTooth * static_cast<float>(kWheelTeeth + kPinionTeeth);
    const glm::mat4 place = moved(kCrankX + apart, kAxis, kGearZ);
    // A gap of the pinion faces the wheel's tooth on the line between the centres.
    const float first = glm::pi<float>() + glm::pi<float>() / static_cast<float>(kPinionTeeth);
    hall.put(Surface::kSteel, toothed_ring(kPinionTeeth, first, 0.05F), place, 411U, vec3(0.55F));
    const std::array<vec2, 4> sleeve{
        {{0.0F, -0.06F}, {0.07F, -0.06F}, {0.07F, 0.06F}, {0.0F, 0.06F}}};
    hall.put(Surface::kSteel, revolve(sleeve, 28), place * lie_along_z(), 412U);
    hall.put(Surface::kSteel, rod({0.0F, 0.0F, -0.14F}, {0.0F, 0.0F, 0.08F}, 0.038F, 24), place,
             413U);
    // A nut holds it.
    hall.put(Surface::kSteel, bolt(0.034F), place * moved(0.0F, 0.0F, 0.06F) * lie_along_z(), 414U);
}

}  // namespace

void build_gears(Assembly& hall) {
    put_wheel(hall);
    put_pinion(hall);
}

}  // namespace obscura::stimuli::machine
