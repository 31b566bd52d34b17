// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Sunet 2018, 4.9: surfaces in a disc of the image occlude by how much their normals differ, less with
// the difference of the depths as shares of the far plane's. It looks like a detection of edges.
#include "technique/disc.glsl"

uniform float u_far_m;
uniform float p_strength;

float accessibility(vec2 uv, float z) {
    vec3 n = normal_at(ivec2(gl_FragCoord.xy));
    float sum = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        ivec2 texel = disc_texel(i, z);
        if (texel.x < 0) continue;
        float apart = min(abs(texelFetch(t_depth, texel, 0).r - z) / u_far_m, 1.0);
        float near = (1.0 - apart) * (1.0 - apart);
        sum += (1.0 - dot(n, normal_at(texel))) * near * near * (3.0 - 2.0 * near);
    }
    float mean = 1.0 - p_strength * sum / float(SAMPLES);
#ifdef UNCLAMPED
    return mean;
#else
    return clamp(mean, 0.0, 1.0);
#endif
}

#include "passes/accessibility.glsl"
