// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Light on every surface, apart from ambient occlusion: the two images of a pair share it.
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"
#include "passes/lighting.glsl"

uniform sampler2D t_normal;
#ifdef ENVIRONMENT
layout(location = 0) out vec4 o_ambient;
#endif
#ifdef DIRECT
layout(location = 1) out vec4 o_direct;     // diffuse light / pi, specular light
#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 code = texelFetch(t_normal, here, 0);
    vec3 n = decode_normal(code.xyz);
#if defined(DIRECT) || defined(IRRADIANCE_GRID)
    vec3 p = view_ray(gl_FragCoord.xy / u_size) * texelFetch(t_depth, here, 0).r;
#else
    vec3 p = vec3(0.0);  // nothing depends on it
#endif
#ifdef ENVIRONMENT
    o_ambient = vec4(irradiance(p, n), 1.0);
#endif
#ifdef DIRECT
    o_direct = direct_light(p, n, code.a * 255.0);
#endif
}
