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
#ifdef LAYER_SHIFT
uniform sampler2D t_second_depth;
uniform float p_second_thickness;
#endif

const vec2 kSliceTurns[] = FAN_TURNS;
const float kSectors = 32.0;

// The lowest `count` of 32 bits.
uint lowest(uint count) { return count >= 32u ? 0xffffffffu : (1u << count) - 1u; }

// A side of a slice. An angle's share of the slice is `middle` at the ray to the camera and changes by
// `per_arc` for each unit of its arc; `open` is the tangent plane's cosine.
struct Side {
    float sign;
    float open;
    float middle;
    float per_arc;
    float jitter;
};

// The sectors between a surface and what lies `thickness_m` behind it.
uint hidden_by(Surface p, Slice s, Side side, float distance_px, Sample q, float thickness_m) {
    float front = arc(p.facing, side.sign * s.across, max(q.cosine, side.open));
    q.there += thickness_m;
    q.deeper += thickness_m;
    place(p, s, distance_px, q);
    float back = arc(p.facing, side.sign * s.across, max(q.cosine, side.open));
    vec2 ends = side.middle + vec2(front, back) * side.per_arc;
    ends = clamp(vec2(min(ends.x, ends.y), max(ends.x, ends.y)) + side.jitter, 0.0, kSectors);
    return lowest(uint(int(ends.y))) & ~lowest(uint(int(ends.x)));
}

// The sectors that the occluders on one side hide.
uint hidden(Surface p, Slice s, Side side) {
    float radius_px = p_radius_m * p_reach / (p.z * p.pixel);
    float farthest_m = p_radius_m * p_cut_off;
    float limit = farthest_m * farthest_m;
    float thickness_m = p_radius_m * p_thickness;
    uint mask = 0u;
    for (int i = 0; i < kSteps; ++i) {
        float distance_px = side.sign * distance_of(i, side.jitter, radius_px, p_step_spread);
#ifdef LAYER_SHIFT
        vec2 px = p.px + s.direction * distance_px;
        if (!in_image(px)) continue;
        ivec2 texel = ivec2(px);
        float first = texelFetch(t_depth, texel, 0).r;
        float second = texelFetch(t_second_depth, texel >> LAYER_SHIFT, 0).r;
        Sample q = carried(p, s, distance_px, px, texel, first);
        if (q.seen && q.squared <= limit) {
            mask |= hidden_by(p, s, side, distance_px, q, thickness_m);
        }
        q = carried(p, s, distance_px, px, texel, second);
        if (q.seen && q.squared <= limit) {
            mask |= hidden_by(p, s, side, distance_px, q, p_radius_m * p_second_thickness);
        }
#else
        Sample q = sample_at(p, s, distance_px);
        uint found = hidden_by(p, s, side, distance_px, q, thickness_m);
        mask |= q.seen && q.squared <= limit ? found : 0u;
#endif
    }
    return mask;
}

float accessibility(vec2 uv, float z) {
    Surface p = surface_at(uv, z);
    vec3 turn = texelFetch(t_turns, ivec2(gl_FragCoord.xy) % NOISE_SIZE, 0).xyz;
    float visible = 0.0;
    float open = 0.0;
    for (int i = 0; i < FAN_COUNT; ++i) {
        vec2 by = kSliceTurns[i];
        Slice s = slice_of(p, vec2(turn.x * by.x - turn.y * by.y, turn.x * by.y + turn.y * by.x));
        float after = arc(p.facing, s.across, -s.sine);
        float before = arc(p.facing, -s.across, s.sine);
        float per_arc = kSectors / (after + before);
        float middle = before * per_arc;
        uint mask = hidden(p, s, Side(1.0, -s.sine, middle, per_arc, turn.z)) |
                    hidden(p, s, Side(-1.0, s.sine, middle, -per_arc, turn.z));
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
