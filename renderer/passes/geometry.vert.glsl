// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "passes/shared_constants.h"

layout(location = 0) in vec3 a_position_m;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec4 a_color;

uniform mat4 u_view;        // view from world
uniform mat4 u_projection;  // clip from view

// The two images of a pair may use different variants of this shader; their pixels must agree.
invariant gl_Position;
invariant out vec3 v_view_position;
out vec4 v_color;
#ifdef NORMAL
out vec3 v_normal;
#endif
#ifdef NORMAL_MAPPING
out vec4 v_tangent;
#endif
#ifdef UV
out vec2 v_uv;
#endif

void main() {
    vec4 view_position = u_view * vec4(a_position_m, 1.0);
    v_view_position = view_position.xyz;
    v_color = a_color;
#ifdef NORMAL
    v_normal = mat3(u_view) * a_normal;
#endif
#ifdef NORMAL_MAPPING
    v_tangent = vec4(mat3(u_view) * a_tangent.xyz, a_tangent.w);
#endif
#ifdef UV
    v_uv = a_uv;
#endif
    gl_Position = u_projection * view_position;
}
