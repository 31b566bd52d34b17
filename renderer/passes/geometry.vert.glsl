// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "passes/shared_constants.h"

layout(location = 0) in vec3 a_position_m;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec4 a_color;

uniform mat3 u_view;        // view from world, directions
uniform vec3 u_eye_m;       // the camera in the world
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
    // The difference first: far from the origin it is exact where a sum of large products is not.
    v_view_position = u_view * (a_position_m - u_eye_m);
    v_color = a_color;
#ifdef NORMAL
    v_normal = u_view * a_normal;
#endif
#ifdef NORMAL_MAPPING
    v_tangent = vec4(u_view * a_tangent.xyz, a_tangent.w);
#endif
#ifdef UV
    v_uv = a_uv;
#endif
    gl_Position = u_projection * vec4(v_view_position, 1.0);
}
