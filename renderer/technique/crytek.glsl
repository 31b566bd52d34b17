// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Jakobsen 2010, Appendix A, after Kajalin 2009: texture space, depth only. Its artefacts are kept:
// a wall that faces the camera has 0.75, convex edges are brighter, near pillars darken a far wall.
#include "passes/view.glsl"
#include "technique/rotation.glsl"
#include "technique/sampling.glsl"

uniform float p_offset_scale;
uniform float u_far_m;

#ifndef FOR_EACH_POINT
#error the offsets before rotation and scale must be defined
#endif

float sample_accessibility(vec2 uv, float d, vec3 offset) {
    vec3 point = vec3(uv + offset.xy, d + offset.z * d);
    float ds = depth_at(point.xy) / u_far_m;
    return ds >= 1.0 ? 1.0 : mix(ds > point.z ? 1.0 : 0.0, 0.5, clamp(d - ds, 0.0, 1.0));
}

float accessibility(vec2 uv, float z) {
    mat3 rotation = rotation_to(random_vector()) * p_offset_scale;
    float d = z / u_far_m;
    float sum = 0.0;
#define ADD(point) sum += sample_accessibility(uv, d, rotation * point);
    FOR_EACH_POINT(ADD)
    float mean = sum / float(SAMPLES);
#ifdef UNCLAMPED
    return mean * mean + mean;
#else
    return clamp(mean * mean + mean, 0.0, 1.0);
#endif
}

#include "passes/accessibility.glsl"
