// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 a_position_m;

uniform mat4 u_shadow_clip;  // the light's clip space from world

void main() { gl_Position = u_shadow_clip * vec4(a_position_m, 1.0); }
