// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Luft et al. 2006: the image darkens by how far the depth lies behind the blurred depth.
#include "passes/shared_constants.h"

uniform sampler2D t_colour;
uniform sampler2D t_depth;
uniform sampler2D t_blurred_depth;
uniform float u_far_m;
uniform float p_strength;
layout(location = 0) out vec4 o_colour;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(t_colour, here, 0);
    float depth_m = texelFetch(t_depth, here, 0).r;
    float behind = min(depth_m / u_far_m, 1.0) - texelFetch(t_blurred_depth, here, 0).r;
    float less = depth_m < kBackgroundLimit_m ? p_strength * max(behind, 0.0) : 0.0;
    o_colour = vec4(max(colour.rgb - less, vec3(0.0)), colour.a);
}
