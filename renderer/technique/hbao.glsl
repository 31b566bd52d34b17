// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Bavoil and Sainz 2008: in each direction of the image the horizon starts above the tangent plane by
// the bias; a sample above it occludes what it adds to the horizon's sine, less with its distance.
#include "technique/slices.glsl"
#ifndef FAN_TURNS
#error the directions' turns must be defined
#endif

uniform float p_radius_m;
uniform float p_reach;
uniform float p_bias;
uniform float p_strength;

const vec2 kDirectionTurns[] = FAN_TURNS;

float accessibility(vec2 uv, float z) {
    Surface p = surface_at(uv, z);
    vec3 turn = texelFetch(t_turns, ivec2(gl_FragCoord.xy) % NOISE_SIZE, 0).xyz;
    float radius_m = p_radius_m * p_reach;
    float radius_px = radius_m / (z * p.pixel);
    float per_squared = 1.0 / max(radius_m * radius_m, 1.0e-30);
    float bias_cosine = sqrt(1.0 - p_bias * p_bias);
    float occluded = 0.0;
    for (int i = 0; i < FAN_COUNT; ++i) {
        vec2 by = kDirectionTurns[i];
        Slice s = slice_of(p, vec2(turn.x * by.x - turn.y * by.y, turn.x * by.y + turn.y * by.x));
        // No higher than the ray to the camera.
        float horizon = -s.sine < bias_cosine ? s.cosine * p_bias - s.sine * bias_cosine : 1.0;
        for (int j = 0; j < kSteps; ++j) {
            Sample q = sample_at(p, s, distance_of(j, turn.z, radius_px, p_step_spread));
            if (!q.seen) continue;
            float weight = max(1.0 - q.squared * per_squared, 0.0);
            // Beyond the reach nothing is seen.
            float sine = weight > 0.0 ? q.cosine : horizon;
            occluded += weight * max(sine - horizon, 0.0);
            horizon = max(horizon, sine);
        }
    }
    float mean = 1.0 - p_strength * occluded / float(FAN_COUNT);
#ifndef UNCLAMPED
    mean = clamp(mean, 0.0, 1.0);
#endif
    return mean < 1.0 ? pow(max(mean, 1.0e-9), p_power) : mean;
}

#include "passes/accessibility.glsl"
