// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Therrien et al. 2023: every sample is the front of an occluder of constant thickness, and hides the
// sectors of its slice between the angles of its front and its back; light passes behind. The sectors
// are equal shares of the slice's cosine-weighted integral.
#include "technique/slices.glsl"
#ifndef FAN_TURNS
#error the slices' turns must be defined
#endif

uniform float p_radius_m;
uniform float p_reach;
uniform float p_cut_off;
uniform float p_thickness;
uniform float p_step_spread;
uniform float p_power;

const vec2 kSliceTurns[] = FAN_TURNS;
const float kSectors = 32.0;

// The lowest `count` of 32 bits.
uint lowest(uint count) { return count >= 32u ? 0xffffffffu : (1u << count) - 1u; }

// The sectors that the occluders on one side hide. An angle's share of the slice is `middle` at the ray
// to the camera and changes by `per_arc` for each unit of its arc; `open` is the tangent plane's cosine.
uint hidden(Surface p, Slice s, float side, float jitter, float open, float middle, float per_arc) {
    float radius_px = p_radius_m * p_reach / (p.z * p.pixel);
    float farthest_m = p_radius_m * p_cut_off;
    float thickness_m = p_radius_m * p_thickness;
    uint mask = 0u;
    for (int i = 0; i < kSteps; ++i) {
        float distance_px = side * distance_of(i, jitter, radius_px, p_step_spread);
        Sample q = sample_at(p, s, distance_px);
        if (!q.seen || q.squared > farthest_m * farthest_m) continue;
        float front = arc(p.facing, side * s.across, max(q.cosine, open));
        q.there += thickness_m;
        q.deeper += thickness_m;
        place(p, s, distance_px, q);
        float back = arc(p.facing, side * s.across, max(q.cosine, open));
        vec2 ends = middle + vec2(front, back) * per_arc;
        ends = clamp(vec2(min(ends.x, ends.y), max(ends.x, ends.y)) + jitter, 0.0, kSectors);
        mask |= lowest(uint(ends.y)) & ~lowest(uint(ends.x));
    }
    return mask;
}

float accessibility(vec2 uv, float z) {
    Surface p = surface_at(uv, z);
    vec3 turn = texelFetch(t_turns, ivec2(gl_FragCoord.xy) % kTileSize, 0).xyz;
    float visible = 0.0;
    float open = 0.0;
    for (int i = 0; i < FAN_COUNT; ++i) {
        vec2 by = kSliceTurns[i];
        Slice s = slice_of(p, vec2(turn.x * by.x - turn.y * by.y, turn.x * by.y + turn.y * by.x));
        float after = arc(p.facing, s.across, -s.sine);
        float before = arc(p.facing, -s.across, s.sine);
        float per_arc = kSectors / (after + before);
        float middle = before * per_arc;
        uint mask = hidden(p, s, 1.0, turn.z, -s.sine, middle, per_arc) |
                    hidden(p, s, -1.0, turn.z, s.sine, middle, -per_arc);
        visible += (after + before) * (1.0 - float(bitCount(mask)) / kSectors);
        open += after + before;
    }
    float mean = visible / open;
#ifndef UNCLAMPED
    mean = clamp(mean, 0.0, 1.0);
#endif
    return mean < 1.0 ? pow(max(mean, 1.0e-9), p_power) : mean;
}

#include "passes/accessibility.glsl"
