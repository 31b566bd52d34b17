// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The ND-buffer pipeline's second drawing of the scene (Sunet 2018, 4.2.1): what composite.frag.glsl
// makes of a G-buffer, from the surfaces themselves.
#include "passes/display.glsl"
#include "passes/lit_surface.glsl"

#ifdef ACCESSIBILITY
#include "passes/accessibility_of_sample.glsl"
#endif
#ifdef CUT_OUT
uniform float u_alpha_cutoff;
#endif
layout(location = 0) out vec4 o_color;

void main() {
#ifdef CUT_OUT
    if (surface_alpha() < u_alpha_cutoff) discard;
#endif
#ifdef ACCESSIBILITY
    vec3 color = lit_surface(accessibility_of_sample(ivec2(gl_FragCoord.xy), -v_view_position.z), 1.0);
#else
    vec3 color = lit_surface(1.0, 1.0);
#endif
#ifdef HDR
    o_color = vec4(color, 1.0);
#else
    o_color = vec4(encode_srgb(color), 1.0);
#endif
}
