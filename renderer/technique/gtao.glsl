// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Jimenez et al. 2016: two horizons a slice, between which the cosine-weighted visibility has a closed
// form. What is visible is divided by what an open surface has in the same slices, so a plane has 1 in
// every pixel and not only on the mean.
#include "technique/slices.glsl"
#ifndef FAN_TURNS
#error the slices' turns must be defined
#endif

uniform float p_radius_m;
uniform float p_reach;
uniform float p_falloff;
#ifndef p_thin_occluder
uniform float p_thin_occluder;
#endif

const vec2 kSliceTurns[] = FAN_TURNS;

// The largest cosine of a horizon on one side, at least the tangent plane's.
float horizon(Surface p, Slice s, float side, float jitter, float radius_m, float open) {
    float radius_px = radius_m / (p.z * p.pixel);
    float per_m = 1.0 / max(radius_m * p_falloff, 1.0e-30);
    float found = open;
    for (int i = 0; i < kSteps; ++i) {
        Sample q = sample_at(p, s, side * distance_of(i, jitter, radius_px, p_step_spread));
        float weight = q.seen ? clamp((radius_m - sqrt(q.squared)) * per_m, 0.0, 1.0) : 0.0;
        float cosine = open + weight * (max(q.cosine, open) - open);
        found = max(cosine, mix(found, cosine, p_thin_occluder));
    }
    return found;
}

float accessibility(vec2 uv, float z) {
    Surface p = surface_at(uv, z);
    vec3 turn = texelFetch(t_turns, ivec2(gl_FragCoord.xy) % NOISE_SIZE, 0).xyz;
    float radius_m = p_radius_m * p_reach;
    float visible = 0.0;
    float open = 0.0;
    for (int i = 0; i < FAN_COUNT; ++i) {
        vec2 by = kSliceTurns[i];
        Slice s = slice_of(p, vec2(turn.x * by.x - turn.y * by.y, turn.x * by.y + turn.y * by.x));
        float after = horizon(p, s, 1.0, turn.z, radius_m, -s.sine);
        float before = horizon(p, s, -1.0, turn.z, radius_m, s.sine);
        visible += arc(p.facing, s.across, after) + arc(p.facing, -s.across, before);
        open += arc(p.facing, s.across, -s.sine) + arc(p.facing, -s.across, s.sine);
    }
    float mean = visible / open;
#ifndef UNCLAMPED
    mean = clamp(mean, 0.0, 1.0);
#endif
    return mean < 1.0 ? pow(max(mean, 1.0e-9), p_power) : mean;
}

#include "passes/accessibility.glsl"
