// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The G-buffer of Jakobsen 2010, Table 1, and the light that surfaces send out.
#include "passes/normal_codec.glsl"
#include "passes/surface.glsl"
#ifdef DEPTH
#include "passes/depth_of_sample.glsl"
#endif

#ifdef CUT_OUT
uniform float u_alpha_cutoff;
#endif

#ifdef ALBEDO
layout(location = 0) out vec4 o_albedo;
#endif
#ifdef NORMAL
layout(location = 1) out vec4 o_normal;
#endif
#ifdef DEPTH
layout(location = 2) out float o_depth_m;
#endif
#ifdef EMISSION
layout(location = 3) out vec4 o_emission;
#endif
#ifdef POSITION
layout(location = 4) out vec4 o_position_m;
#endif

void main() {
#ifdef DEPTH
    float depth_m = depth_of_sample(v_view_position);
#endif
#ifdef CUT_OUT
    if (surface_alpha() < u_alpha_cutoff) discard;
#endif
#ifdef ALBEDO
    vec3 albedo = surface_albedo();
    vec2 specular = surface_specular(albedo);
    o_albedo = vec4(albedo, specular.x);
#else
    vec2 specular = vec2(0.0);  // an ND-buffer is not lit
#endif
#ifdef NORMAL
    o_normal = vec4(encode_normal(surface_normal()), specular.y / 255.0);
#endif
#ifdef POSITION
    o_position_m = vec4(v_view_position, 0.0);
#endif
#ifdef DEPTH
    o_depth_m = depth_m;
#endif
#ifdef EMISSION
    o_emission = surface_emission();
#endif
}
