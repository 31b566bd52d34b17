// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Whinham 2017, 2.7 and B.1, as in Sunet 2018, 4.3: points of the hemisphere about the normal, of which
// those behind a visible surface are occluded.
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"
#include "technique/sampling.glsl"
#include "technique/tangent_frame.glsl"
#ifndef FOR_EACH_POINT
#error the points of the hemisphere about +Z must be defined
#endif

uniform float p_radius_m;
uniform float p_bias;
uniform float p_range_check;
uniform float p_power;
uniform sampler2D t_normal;

float hidden(vec3 s, float z) {
    float there = depth_at_px(project_to_px(s));
#ifdef UNCLAMPED
    if (isnan(s.z)) return s.z;
#endif
    bool near = p_range_check < 0.5 || abs(z - there) <= p_radius_m;
    return near && -s.z - there > p_bias * p_radius_m ? 1.0 : 0.0;
}

float accessibility(vec2 uv, float z) {
    vec3 p = point_at(uv, ivec2(gl_FragCoord.xy), z);
    vec3 n = decode_normal(texelFetch(t_normal, ivec2(gl_FragCoord.xy), 0).xyz);
    mat3 frame = tangent_frame(n, random_vector());
    float sum = 0.0;
#define ADD(point) sum += hidden(p + frame * point * p_radius_m, z);
    FOR_EACH_POINT(ADD)
    float mean = 1.0 - sum / float(SAMPLES);
    return mean < 1.0 ? pow(max(mean, 1.0e-9), p_power) : mean;
}

#include "passes/accessibility.glsl"
