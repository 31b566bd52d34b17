// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// McGuire et al. 2011: every surface in a disc of the image occludes by how far it rises above the
// tangent plane over the square of its distance. Lengths are in radii, so strength has no unit.
#include "technique/disc.glsl"

uniform float p_strength;
uniform float p_bias;
uniform float p_epsilon;
uniform float p_power;

float accessibility(vec2 uv, float z) {
    ivec2 here = ivec2(gl_FragCoord.xy);
#ifdef POSITION
    vec3 p = point_at(uv, here, z);
#else
    vec3 ray = view_ray(uv);
#endif
    vec3 n = normal_at(here);
    float least_squared = p_epsilon * p_radius_m * p_radius_m + 1.0e-30;
    float sum = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        ivec2 texel = disc_texel(i, z);
        if (texel.x < 0) continue;
        float there = texelFetch(t_depth, texel, 0).r;
        if (there >= kBackgroundLimit_m) continue;
#ifdef POSITION
        vec3 v = point_at((vec2(texel) + 0.5) / u_size, texel, there) - p;
#else
        // The difference first, so that near points lose no digits.
        vec2 off_px = vec2(texel - here);
        vec3 v = vec3(off_px * (pixel_size() * there), 0.0) + ray * (there - z);
#endif
        sum += max(dot(v, n) - z * p_bias, 0.0) / (dot(v, v) + least_squared);
    }
    float mean = 1.0 - 2.0 * p_strength * p_radius_m * sum / float(SAMPLES);
#ifndef UNCLAMPED
    mean = clamp(mean, 0.0, 1.0);
#endif
    return mean < 1.0 ? pow(max(mean, 1.0e-9), p_power) : mean;
}

#include "passes/accessibility.glsl"
