// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 a_position_m;
#ifdef CUT_OUT
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec4 a_color;
out vec2 v_uv;
out float v_alpha;
#endif

uniform mat4 u_shadow_clip;  // the light's clip space from world

void main() {
#ifdef CUT_OUT
    v_uv = a_uv;
    v_alpha = a_color.a;
#endif
    gl_Position = u_shadow_clip * vec4(a_position_m, 1.0);
}
