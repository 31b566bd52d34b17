// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Jakobsen 2010, Appendix C, after Bavoil and Sainz 2009: as `blizzard`, but the first of four equal
// steps that finds an occluder counts.
#include "technique/view_space.glsl"

const int kSteps = 4;

float march_accessibility(vec3 p, vec3 offset_m, float z) {
    vec3 step_m = offset_m / float(kSteps);
    float delta = 0.0;
    for (int k = 1; k <= kSteps; ++k) {
        delta = depth_difference(p + step_m * float(k), z);
        if (delta >= p_full_threshold_m) break;
    }
    return sample_accessibility(delta);
}

float accessibility(vec2 uv, float z) {
    vec3 p = point_at(uv, ivec2(gl_FragCoord.xy), z);
    vec3 n = decode_normal(texelFetch(t_normal, ivec2(gl_FragCoord.xy), 0).xyz);
    vec3 r = random_vector();
    float sum = 0.0;
#define ADD(point) sum += march_accessibility(p, sample_offset(point, r, n), z);
    FOR_EACH_POINT(ADD)
    return sum / float(SAMPLES);
}

#include "passes/accessibility.glsl"
