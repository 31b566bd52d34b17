// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A surface that is seen through, lit as the others are, over what lies behind it (linear light).
#include "passes/lit_surface.glsl"

#ifdef ACCESSIBILITY
#include "passes/accessibility_of_sample.glsl"
uniform float u_occluding_opacity;
#endif
layout(location = 0) out vec4 o_color;

void main() {
    float alpha = clamp(surface_alpha(), 0.0, 1.0);
    float open = 1.0;
#ifdef ACCESSIBILITY
    if (alpha >= u_occluding_opacity) {
        open = accessibility_of_sample(ivec2(gl_FragCoord.xy), -v_view_position.z);
    }
#endif
    o_color = vec4(lit_surface(open, alpha), alpha);
}
