// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/slices_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {

void Bounded::operator+=(const Bounded& other) {
    value += other.value;
    low += other.low;
    high += other.high;
}

Bounded power_of(const Bounded& a, const Rounded& power) {
    constexpr double kLeast = 1.0e-9;
    const auto of = [&](double base) { return pow(Rounded(std::max(base, kLeast)), power); };
    // What is open to the last digit is left as it is.
    const auto open = [](double base) { return base >= 1.0; };
    return {open(a.value) ? a.value : of(a.value).value, open(a.low) ? a.low : of(a.low).low(),
            open(a.high) ? a.high : of(a.high).high()};
}

Rounded slice_distance_px(int i, int steps, const Turn& turn, const Rounded& radius_px,
                          const Rounded& spread) {
    const Rounded u = (Rounded(i) + Rounded(turn.jitter)) * nearest_float(1.0 / steps);
    const auto mixed = [&u](const Rounded& share) { return Rounded(1.0) - share + u * share; };
    const Rounded squared = u * mixed(min(spread, Rounded(1.0)));
    return Rounded(1.0) + radius_px * squared * mixed(max(spread - Rounded(1.0), Rounded(0.0)));
}

Bounded arc_of(const Rounded& facing, const Rounded& across, const Bounded& c) {
    constexpr double kAcosError = 1.0e-6;
    constexpr int kOperations = 8;
    const auto exact = [&](double cosine) {
        const double to = std::clamp(cosine, -1.0, 1.0);
        const double sine = std::sqrt(1.0 - to * to);
        return facing.value * sine * sine + across.value * (std::acos(to) - to * sine);
    };
    const auto error = [&](double cosine) {
        const double squared = std::max(0.0, 1.0 - cosine * cosine);
        const double root = std::sqrt(squared + 2.0 * kUlp) - std::sqrt(squared);
        return facing.error + std::numbers::pi * across.error +
               kOperations * kUlp * (facing.size() + std::numbers::pi * across.size()) +
               across.size() * (kAcosError + root);
    };
    return {exact(c.value), exact(c.high) - error(c.high), exact(c.low) + error(c.low)};
}

SeenTexels seen_texels(const SeenBuffers& buffers, const Rounded& px_x, const Rounded& px_y) {
    constexpr double kWide_px = 0.5;  // no rounding of a sound place is as wide
    const auto texel = [&](double x, double y) {
        const bool inside = x >= 0.0 && y >= 0.0 && x < buffers.width && y < buffers.height;
        return inside ? SeenTexel{true, static_cast<int>(x), static_cast<int>(y)} : SeenTexel{};
    };
    SeenTexels seen{{texel(px_x.value, px_y.value)}, false};
    if (!(px_x.error < kWide_px && px_y.error < kWide_px)) {
        seen.any = true;
        return seen;
    }
    for (const double x : {px_x.low(), px_x.high()}) {
        for (const double y : {px_y.low(), px_y.high()}) {
            const SeenTexel other = texel(x, y);
            const SeenTexel& first = seen.list.front();
            const bool same =
                other.inside == first.inside && other.x == first.x && other.y == first.y;
            if (!same) seen.list.push_back(other);
        }
    }
    return seen;
}

SlicesModel::SlicesModel(const SeenBuffers& buffers) : buffers_(buffers), view_(buffers) {}

SliceSurface SlicesModel::surface(int x, int y) const {
    SliceSurface p;
    p.x = x;
    p.y = y;
    p.z = Rounded(buffers_.depth_at(x, y));
    p.ray = view_.ray_to(x, y);
    p.squared_length = dot(p.ray, p.ray);
    p.length = sqrt(p.squared_length);
    p.normal = view_.normal(x, y);
    p.facing = max(-(dot(p.normal, p.ray) / p.length), nearest_float(1.0e-3));
    p.pixel = view_.pixel();
    const Rounded per_m = -p.pixel / (p.facing * p.length * p.z);
    p.slope_x = p.normal.x * per_m;
    p.slope_y = p.normal.y * per_m;
    return p;
}

SlicePlane SlicesModel::slice(const SliceSurface& p, const Turn& turn, const Turn& by) const {
    const Rounded cosine(turn.cosine);
    const Rounded sine(turn.sine);
    SlicePlane s;
    s.x = cosine * nearest_float(by.cosine) - sine * nearest_float(by.sine);
    s.y = cosine * nearest_float(by.sine) + sine * nearest_float(by.cosine);
    s.along = s.x * p.ray.x + s.y * p.ray.y;
    const Rounded part = s.along / p.length;
    s.across = (s.x * p.normal.x + s.y * p.normal.y + p.facing * part) *
               inverse_sqrt(Rounded(1.0) - part * part);
    const Rounded inverse = inverse_sqrt(p.facing * p.facing + s.across * s.across);
    s.sine = s.across * inverse;
    s.cosine = p.facing * inverse;
    return s;
}

SliceSample SlicesModel::sample(const SliceSurface& p, const SlicePlane& s,
                                const Rounded& distance_px, const SeenTexel& texel, float depth_m,
                                const Rounded& px_x, const Rounded& px_y) const {
    const Rounded z(depth_m);
    if (z.value >= static_cast<double>(kBackgroundLimit_m)) return {};
    const Rounded off_x = px_x - Rounded(texel.x + 0.5);
    const Rounded off_y = px_y - Rounded(texel.y + 0.5);
    const Rounded change =
        clamp(z * (p.slope_x * off_x + p.slope_y * off_y), nearest_float(-0.9), Rounded(0.5));
    SliceSample found;
    found.seen = true;
    found.there = z / (Rounded(1.0) + change);
    found.deeper = (z - p.z) - found.there * change;
    return moved(p, s, distance_px, found, Rounded(0.0));
}

SliceSample SlicesModel::moved(const SliceSurface& p, const SlicePlane& s,
                               const Rounded& distance_px, SliceSample sample,
                               const Rounded& farther_m) {
    sample.there = sample.there + farther_m;
    sample.deeper = sample.deeper + farther_m;
    const Rounded beside = distance_px * p.pixel * sample.there;
    const Rounded with_ray = beside * s.along + sample.deeper * p.squared_length;
    sample.squared = max(beside * beside + sample.deeper * (beside * s.along + with_ray),
                         nearest_float(1.0e-36));
    const Rounded cosine = -with_ray * inverse_sqrt(sample.squared * p.squared_length);
    sample.cosine =
        between(cosine.value, std::max(cosine.low(), -1.0), std::min(cosine.high(), 1.0));
    return sample;
}

SliceSamples SlicesModel::samples(const SliceSurface& p, const SlicePlane& s,
                                  const Rounded& distance_px, bool second) const {
    const Rounded px_x = Rounded(p.x + 0.5) + s.x * distance_px;
    const Rounded px_y = Rounded(p.y + 0.5) + s.y * distance_px;
    const SeenTexels texels = seen_texels(buffers_, px_x, px_y);
    SliceSamples found;
    for (const SeenTexel& texel : texels.list) {
        if (!texel.inside) {
            found.emplace_back();
            continue;
        }
        const float depth_m =
            second ? buffers_.second_at(texel.x, texel.y) : buffers_.depth_at(texel.x, texel.y);
        found.push_back(sample(p, s, distance_px, texel, depth_m, px_x, px_y));
    }
    if (texels.any) {
        SliceSample any;
        any.seen = true;
        any.known = false;
        found.push_back({});
        found.push_back(any);
    }
    return found;
}

}  // namespace obscura::renderer
