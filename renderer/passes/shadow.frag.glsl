// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#ifdef CUT_OUT
in vec2 v_uv;
in float v_alpha;
uniform sampler2D t_albedo_map;
uniform int u_has_albedo_map;
uniform float u_opacity;
uniform float u_alpha_cutoff;
#endif

void main() {
#ifdef CUT_OUT
    float alpha = u_opacity * v_alpha;
    if (u_has_albedo_map != 0) alpha *= textureLod(t_albedo_map, v_uv, 0.0).a;
    if (alpha < u_alpha_cutoff) discard;
#endif
}
