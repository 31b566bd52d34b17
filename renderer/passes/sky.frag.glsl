// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The environment behind everything, on pixels that no triangle covers.
#include "passes/view.glsl"
#include "passes/display.glsl"

uniform sampler2D t_environment;
uniform mat3 u_world_from_view;
layout(location = 0) out vec4 o_color;

void main() {
    vec3 d = normalize(u_world_from_view * view_ray(gl_FragCoord.xy / u_size));
    vec2 uv = vec2(atan(d.x, -d.z) * 0.15915494309, acos(clamp(d.y, -1.0, 1.0)) * 0.31830988618);
    vec3 radiance = textureLod(t_environment, uv, 0.0).rgb;
#ifdef HDR
    o_color = vec4(radiance, 1.0);
#else
    o_color = vec4(encode_srgb(radiance), 1.0);
#endif
}
