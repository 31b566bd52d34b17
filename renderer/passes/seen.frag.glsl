// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What the technique sees where it is not what the buffers before hold: every STEP-th column and row of
// them; with DEPTH_REBUILT the linear depth from that of the depth test, with NORMAL_REBUILT the normal
// from the depths of neighbours. Its visibility is copied too, so that empty pixels stay empty.
#include "passes/normal_codec.glsl"
#include "passes/view.glsl"

uniform sampler2D t_visibility;
#ifdef DEPTH_REBUILT
uniform float u_near_m;
uniform float u_far_m;
#endif
layout(location = 0) out float o_depth_m;
#ifdef NORMAL
#ifndef NORMAL_REBUILT
uniform sampler2D t_normal;
#endif
layout(location = 1) out vec4 o_normal;
#endif
#ifdef POSITION_KEPT
uniform sampler2D t_position;
layout(location = 2) out vec4 o_position_m;
#endif

float depth_of(ivec2 texel) {
#ifdef DEPTH_REBUILT
    float d = texelFetch(t_visibility, texel, 0).r;
    return d < 1.0 ? u_near_m * u_far_m / (u_far_m - d * (u_far_m - u_near_m)) : kBackgroundDepth_m;
#else
    return texelFetch(t_depth, texel, 0).r;
#endif
}

#ifdef NORMAL_REBUILT
vec3 point_of(ivec2 texel) {
    return view_ray((vec2(texel) + 0.5) / vec2(textureSize(t_visibility, 0))) * depth_of(texel);
}

// The change of the point from one texel to the next, on the side where depth changes less.
vec3 change(ivec2 texel, vec3 here, ivec2 by) {
    ivec2 last = textureSize(t_visibility, 0) - 1;
    ivec2 before = texel - by;
    ivec2 after = texel + by;
    vec3 back = all(greaterThanEqual(before, ivec2(0))) ? here - point_of(before) : vec3(1.0e30);
    vec3 on = all(lessThanEqual(after, last)) ? point_of(after) - here : vec3(1.0e30);
    return abs(back.z) < abs(on.z) ? back : on;
}
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) * STEP;
    gl_FragDepth = texelFetch(t_visibility, texel, 0).r;
    o_depth_m = depth_of(texel);
#ifdef POSITION_KEPT
    o_position_m = texelFetch(t_position, texel, 0);
#endif
#ifdef NORMAL
#ifdef NORMAL_REBUILT
    vec3 here = point_of(texel);
    vec3 n = cross(change(texel, here, ivec2(1, 0)), change(texel, here, ivec2(0, 1)));
    float squared = dot(n, n);
    bool sound = squared > 0.0 && squared < 1.0e30;
    o_normal = vec4(encode_normal(sound ? n * inversesqrt(squared) : vec3(0.0, 0.0, 1.0)), 0.0);
#else
    o_normal = texelFetch(t_normal, texel, 0);
#endif
#endif
}
