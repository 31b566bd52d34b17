// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "stimuli/scenes/atrium/parts.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

/// Points of a quarter- or half-round moulding, from `from_rad` to `to_rad`.
void add_arc(std::vector<vec2>& profile, vec2 centre, float radius, float from_rad, float to_rad,
             int steps) {
    for (int i = 0; i <= steps; ++i) {
        const float angle =
            from_rad + (to_rad - from_rad) * static_cast<float>(i) / static_cast<float>(steps);
        profile.push_back(centre + radius * vec2(std::cos(angle), std::sin(angle)));
    }
}

/// Attic base (two rolls with a hollow between), shaft with entasis, neck ring and the bell that
/// carries the leaves.
std::vector<vec2> turned_profile(const ColumnShape& shape, float from_y, float bell_y,
                                 float bell_top) {
    const float r = shape.radius;
    const float half_pi = glm::half_pi<float>();
    std::vector<vec2> profile{{0.6F * r, from_y}};
    const float roll = 0.16F * r;
    add_arc(profile, {1.22F * r, from_y + roll}, roll, -half_pi, half_pi, 6);
    const float hollow_y = from_y + 2.0F * roll + 0.05F * r;
    profile.emplace_back(1.2F * r, hollow_y);
    profile.emplace_back(1.13F * r, hollow_y + 0.05F * r);
    profile.emplace_back(1.12F * r, hollow_y + 0.14F * r);
    profile.emplace_back(1.18F * r, hollow_y + 0.2F * r);
    add_arc(profile, {1.1F * r, hollow_y + 0.2F * r + 0.7F * roll}, 0.7F * roll, -half_pi, half_pi,
            4);
    const float foot_y = hollow_y + 0.2F * r + 1.4F * roll;
    profile.emplace_back(1.07F * r, foot_y + 0.02F * r);
    const int shaft_steps = shape.leaf_detail + 2;
    for (int i = 0; i <= shaft_steps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(shaft_steps);
        const float flare = 0.06F * std::exp(-14.0F * t);
        profile.emplace_back(r * (1.0F + flare - 0.15F * t * t),
                             foot_y + 0.06F * r + (bell_y - 0.26F * r - foot_y - 0.06F * r) * t);
    }
    add_arc(profile, {0.88F * r, bell_y - 0.1F * r}, 0.1F * r, -half_pi, half_pi, 4);
    constexpr int kBellSteps = 4;
    for (int i = 0; i <= kBellSteps; ++i) {
        const float t = static_cast<float>(i) / kBellSteps;
        profile.emplace_back(r * (0.86F + 0.3F * t * t * t), bell_y + (bell_top - bell_y) * t);
    }
    return profile;
}

/// An acanthus-like leaf that lies on the bell and curls outwards at its tip; a thin closed body.
Mesh capital_leaf(float radius, float width, float height, float curl, int detail) {
    PatchOptions options;
    options.columns = detail;
    options.rows = detail;
    options.closed_u = true;
    options.size_m = {2.0F * width, height};
    // The middle of the leaf as (outwards, upwards): along the bell, then over and down.
    const auto spine = [&](float v) {
        const float over = std::max(0.0F, v - 0.78F) / 0.22F;
        return vec2(curl * (v * v * v + 0.35F * over),
                    height * (0.92F * v + 0.05F * over - 0.17F * over * over));
    };
    return patch(options, [=](float u, float v) {
        const float around = u * glm::two_pi<float>();
        const float lobes = 1.0F + 0.15F * std::cos(v * 21.0F);
        const float taper = std::sqrt(std::max(0.0F, 1.0F - std::pow(v, 6.0F)));
        const float half_width = 0.5F * width * lobes * taper * (0.8F + 0.8F * v * (1.0F - v));
        const float across = -half_width * std::cos(around);
        const float rib = std::exp(-std::pow(across / (0.12F * width), 2.0F));
        const float front = std::max(0.0F, std::sin(around));
        const float back = std::min(0.0F, std::sin(around));
        const float veins = 1.0F + 0.35F * std::cos(across / width * 26.0F);
        const float thick =
            width * taper * (0.15F * front * veins + 0.12F * rib * front + 0.05F * back);
        const vec2 ahead = spine(std::min(1.0F, v + 0.02F)) - spine(std::max(0.0F, v - 0.02F));
        const vec2 outwards = glm::normalize(vec2(ahead.y, -ahead.x));
        const vec2 place = spine(v) + outwards * thick * glm::smoothstep(-0.02F, 0.12F, v);
        // The foot is open: it stands in the bell, where nobody sees into it.
        const float out = radius * (0.94F + 0.06F * glm::smoothstep(0.0F, 0.12F, v)) + place.x;
        const float angle = across / radius;
        return vec3(out * std::sin(angle), place.y, out * std::cos(angle));
    });
}

/// The scroll below a corner of the abacus: a band that rises from the bell, `reach` behind the
/// scroll's middle and `rise` below it, and winds itself into a spiral.
Mesh volute(float size, float reach, float rise, int steps) {
    std::vector<vec3> path;
    for (int i = 0; i < 4; ++i) {
        const float t = static_cast<float>(i) / 4.0F;
        path.emplace_back(0.0F, glm::mix(-rise, 0.42F * size, std::sqrt(t)),
                          glm::mix(-reach, -0.28F * size, t * t));
    }
    for (int i = 0; i <= steps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(steps);
        const float angle = 1.1F + t * 10.5F;
        const float radius = size * (0.5F - 0.4F * t);
        path.emplace_back(0.0F, radius * std::sin(angle), -radius * std::cos(angle));
    }
    const std::vector<vec2> band = [&] {
        std::vector<vec2> points = circle(1.0F, 12);
        for (vec2& point : points) point *= vec2(0.34F, 0.105F) * size;
        return points;
    }();
    std::vector<ProfileFrame> frames;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const vec3 ahead =
            glm::normalize(path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]);
        const vec3 x(1.0F, 0.0F, 0.0F);
        frames.push_back({path[i], x, glm::cross(ahead, x)});
    }
    return sweep(band, frames);
}

void add_capital(Mesh& whole, const ColumnShape& shape, float bell_y, float bell_top) {
    const float height = bell_top - bell_y;
    const float step = glm::two_pi<float>() / static_cast<float>(shape.leaves);
    const float r = shape.radius;
    const float width = 0.94F * r * step;
    const Mesh low = capital_leaf(0.88F * r, width, 0.54F * height, 0.34F * r, shape.leaf_detail);
    const Mesh high = capital_leaf(0.88F * r, width, 0.9F * height, 0.42F * r, shape.leaf_detail);
    const vec3 up(0.0F, 1.0F, 0.0F);
    for (int i = 0; i < shape.leaves; ++i) {
        Placement placement;
        const float angle = step * static_cast<float>(i);
        placement.transform = glm::rotate(at(0.0F, bell_y, 0.0F), angle, up);
        append(whole, low, placement);
        placement.transform = glm::rotate(at(0.0F, bell_y, 0.0F), angle + 0.5F * step, up);
        append(whole, high, placement);
    }
    if (!shape.scrolls) return;
    const Mesh scroll = volute(0.5F * height, 0.57F * shape.abacus - 0.9F * r, 0.55F * height,
                               6 * shape.leaf_detail);
    for (int i = 0; i < 4; ++i) {
        Placement placement;
        const float angle = (static_cast<float>(i) + 0.5F) * glm::half_pi<float>();
        const glm::mat4 turned = glm::rotate(glm::mat4(1.0F), angle, up);
        placement.transform = turned * at(0.0F, bell_top - 0.25F * height, 0.55F * shape.abacus);
        append(whole, scroll, placement);
    }
}

}  // namespace

Mesh column(const ColumnShape& shape) {
    const float r = shape.radius;
    const float plinth = 0.42F * r;
    const float abacus = 0.3F * r;
    const float bell_top = shape.height - abacus;
    const float bell_y = bell_top - 1.75F * r;
    Mesh whole;
    Placement placement;
    placement.transform = at(0.0F, 0.5F * plinth, 0.0F);
    append(whole, bevelled_box({2.9F * r, plinth, 2.9F * r}, 0.05F * r), placement);
    append(whole, revolve(turned_profile(shape, plinth, bell_y, bell_top), shape.segments));
    add_capital(whole, shape, bell_y, bell_top);
    // The abacus: a slab over a smaller one.
    placement.transform = at(0.0F, bell_top + 0.3F * abacus, 0.0F);
    append(whole, bevelled_box({0.88F * shape.abacus, 0.6F * abacus, 0.88F * shape.abacus}, 0.02F),
           placement);
    placement.transform = at(0.0F, shape.height - 0.25F * abacus, 0.0F);
    append(whole, bevelled_box({shape.abacus, 0.5F * abacus, shape.abacus}, 0.016F), placement);
    return whole;
}

}  // namespace obscura::stimuli::atrium
