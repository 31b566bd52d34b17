// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What the technique sees where that is not the image's own G-buffer; with BLENDED, nearly opaque
// blended surfaces (Filion and McNaughton 2008).
#include "passes/depth_of_sample.glsl"
#include "passes/normal_codec.glsl"
#include "passes/surface.glsl"

#ifdef BLENDED
uniform float u_occluding_opacity;
#elif defined(CUT_OUT)
uniform float u_alpha_cutoff;
#endif
layout(location = 0) out float o_depth_m;
#ifdef NORMAL
layout(location = 1) out vec4 o_normal;
#endif
#ifdef POSITION
layout(location = 2) out vec4 o_position_m;
#endif

void main() {
    float depth_m = depth_of_sample(v_view_position);
#ifdef BLENDED
    if (surface_alpha() < u_occluding_opacity) discard;
#elif defined(CUT_OUT)
    if (surface_alpha() < u_alpha_cutoff) discard;
#endif
    o_depth_m = depth_m;
#ifdef POSITION
    o_position_m = vec4(v_view_position, 0.0);
#endif
#ifdef NORMAL
    o_normal = vec4(encode_normal(surface_normal()), u_specular_power / 255.0);
#endif
}
