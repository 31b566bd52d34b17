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
#ifndef p_power
uniform float p_power;
#endif
uniform sampler2D t_normal;
#ifndef FOR_EACH_POINT
#error the points in the unit ball, lengths from half to full, must be defined
#endif

// A sample's offset in the hemisphere about n: reflected through r, turned over where below.
vec3 sample_offset(vec3 point, vec3 r, vec3 n) {
    vec3 o = reflect(point, r);
    return (dot(o, n) < 0.0 ? -o : o) * p_radius_m;
}

// How much nearer to the camera than P the surface at S's pixel is, in metres; never negative.
float depth_difference(vec3 s, float z) {
    float difference = z - depth_at_px(project_to_px(s));
#ifdef UNCLAMPED
    if (isnan(difference)) return difference;
#endif
    return max(0.0, difference);
}

// x to the power of p_power, by squaring where that is a power of 2.
float powered(float x) {
#ifdef SQUARINGS
    for (int i = 0; i < SQUARINGS; ++i) x *= x;
    return x;
#else
    return pow(x, p_power);
#endif
}

// Accessibility of one sample from its depth difference.
float sample_accessibility(float delta) {
#ifdef UNCLAMPED
    if (isnan(delta)) return delta;
#endif
    bool open = delta < p_full_threshold_m || delta > p_no_threshold_m;
    float scaled = delta * p_depth_scale_per_m;
    return open ? 1.0 : powered(1.0 / (1.0 + scaled * scaled));
}
