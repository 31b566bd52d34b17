// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Depth peeling with a least separation (Everitt 2001; Mara et al. 2016): of what lies that far behind
// the first layer, the depth test leaves the nearest.
#include "passes/depth_of_sample.glsl"
#include "passes/surface.glsl"

#ifdef CUT_OUT
uniform float u_alpha_cutoff;
#endif
uniform sampler2D t_depth;
uniform float u_separation_m;
layout(location = 0) out float o_depth_m;

void main() {
    float depth_m = depth_of_sample(v_view_position);
#ifdef CUT_OUT
    if (surface_alpha() < u_alpha_cutoff) discard;
#endif
    float first_m = texelFetch(t_depth, ivec2(gl_FragCoord.xy) * STEP, 0).r;
    if (!(depth_m > first_m + u_separation_m)) discard;
    o_depth_m = depth_m;
}
