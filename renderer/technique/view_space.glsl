// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What `blizzard` and `raymarch` share (Jakobsen 2010, 4.3.2 and Appendices B and C).
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"
#include "technique/sampling.glsl"

uniform float p_radius_m;
uniform float p_full_threshold_m;
uniform float p_no_threshold_m;
uniform float p_depth_scale_per_m;
uniform float p_power;
uniform sampler2D t_normal;
uniform sampler2D t_kernel;  // SAMPLES x 1 points in the unit ball, lengths from half to full

// Sample i's offset in the hemisphere about n: reflected through r, turned over where below.
vec3 sample_offset(int i, vec3 r, vec3 n) {
    vec3 o = reflect(texelFetch(t_kernel, ivec2(i, 0), 0).xyz, r);
    return (dot(o, n) < 0.0 ? -o : o) * p_radius_m;
}

// How much nearer to the camera than P the surface at S's pixel is, in metres; never negative.
float depth_difference(vec3 s, float z) {
    float difference = z - depth_at(project_to_image(s));
#ifdef UNCLAMPED
    if (isnan(difference)) return difference;
#endif
    return max(0.0, difference);
}

// Accessibility of one sample from its depth difference.
float sample_accessibility(float delta) {
#ifdef UNCLAMPED
    if (isnan(delta)) return delta;
#endif
    if (delta < p_full_threshold_m || delta > p_no_threshold_m) return 1.0;
    float scaled = delta * p_depth_scale_per_m;
    return pow(1.0 / (1.0 + scaled * scaled), p_power);
}
