// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Jakobsen 2010, Appendix B, after Filion and McNaughton 2008. The depth is compared with that of P,
// not of the sample point, so occluders between P and S are missed, as in the thesis.
#include "technique/view_space.glsl"

float accessibility(vec2 uv, float z) {
    vec3 p = point_at(uv, ivec2(gl_FragCoord.xy), z);
    vec3 n = decode_normal(texelFetch(t_normal, ivec2(gl_FragCoord.xy), 0).xyz);
    vec3 r = random_vector();
    float sum = 0.0;
#define ADD(point) \
    sum += sample_accessibility(depth_difference(p + sample_offset(point, r, n), z));
    FOR_EACH_POINT(ADD)
    return sum / float(SAMPLES);
}

#include "passes/accessibility.glsl"
