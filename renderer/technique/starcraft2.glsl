// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Filion and McNaughton 2008: points of the hemisphere about the normal, each occluded by how far the
// visible surface lies before it; the wide set of points and the narrow one, of which the darker wins.
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"
#include "technique/sampling.glsl"
#ifndef FOR_EACH_WIDE
#error the points in the unit ball with their weights must be defined
#endif

uniform float p_radius_m;
uniform float p_epsilon;
uniform float p_full_threshold;
uniform float p_no_threshold;
uniform float p_power;
uniform float p_small_radius;
uniform float p_small_power;
uniform float p_footprint;
uniform sampler2D t_normal;
#if DEPTH_SHIFT > 0
uniform sampler2D t_small_depth;
#endif

float seen_depth(vec2 px) {
#if DEPTH_SHIFT > 0
    bool inside = all(greaterThanEqual(px, vec2(0.0))) && all(lessThan(px, u_size));
    float seen = texelFetch(t_small_depth, ivec2(inside ? px : vec2(0.0)) >> DEPTH_SHIFT, 0).r;
    return inside ? seen : kBackgroundDepth_m;
#else
    return depth_at_px(px);
#endif
}

// By how far a surface lies before a sample.
float occlusion(float delta, float radius_m, float power) {
#ifdef UNCLAMPED
    if (isnan(delta)) return delta;
#endif
    if (delta <= p_epsilon * radius_m) return 0.0;
    float past = delta - p_full_threshold * radius_m;
    if (past < 0.0) return 1.0;
    float range_m = max((p_no_threshold - p_full_threshold) * radius_m, 1.0e-30);
    return 1.0 - pow(clamp(past / range_m, 1.0e-9, 1.0), power);
}

float sample_occlusion(vec3 p, vec3 point, vec3 r, vec3 n, float radius_m, float power) {
    vec3 o = reflect(point, r);
    vec3 s = p + (dot(o, n) < 0.0 ? -o : o) * radius_m;
    return occlusion(-s.z - seen_depth(project_to_px(s)), radius_m, power);
}

float accessibility(vec2 uv, float z) {
    vec3 p = point_at(uv, ivec2(gl_FragCoord.xy), z);
    vec3 n = decode_normal(texelFetch(t_normal, ivec2(gl_FragCoord.xy), 0).xyz);
    vec3 r = random_vector();
    float radius_m = min(p_radius_m, p_footprint * 2.0 * u_ray_scale.y * z);
    float wide = 0.0;
#define ADD_WIDE(point, weight) \
    wide += weight * sample_occlusion(p, point, r, n, radius_m, p_power);
    FOR_EACH_WIDE(ADD_WIDE)
    float occluded = wide;
#ifdef FOR_EACH_SMALL
    float small = 0.0;
    radius_m *= p_small_radius;
#define ADD_SMALL(point, weight) \
    small += weight * sample_occlusion(p, point, r, n, radius_m, p_small_power);
    FOR_EACH_SMALL(ADD_SMALL)
    occluded = max(wide, small);
#endif
#ifdef UNCLAMPED
    return 1.0 - occluded;
#else
    return clamp(1.0 - occluded, 0.0, 1.0);
#endif
}

#include "passes/accessibility.glsl"
