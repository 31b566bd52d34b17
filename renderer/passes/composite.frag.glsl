// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Jakobsen 2010, equation 5: accessibility scales the ambient term and nothing else. Accessibility
// that was baked into a material does the same.
#include "passes/display.glsl"

uniform sampler2D t_albedo;
#ifdef ACCESSIBILITY
#include "passes/accessibility_of_sample.glsl"
#if SUPERSAMPLING > 1
uniform sampler2D t_depth;
#endif
#endif
#ifdef ENVIRONMENT
uniform sampler2D t_ambient;
#else
uniform vec3 u_ambient;
#endif
#ifdef DIRECT
uniform sampler2D t_direct;
#endif
#ifdef EMISSION
uniform sampler2D t_emission;
#endif
layout(location = 0) out vec4 o_color;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 albedo = texelFetch(t_albedo, here, 0);
#ifdef ENVIRONMENT
    vec3 light = texelFetch(t_ambient, here, 0).rgb;
#else
    vec3 light = u_ambient;
#endif
#ifdef ACCESSIBILITY
#if SUPERSAMPLING > 1
    light *= accessibility_of_sample(here, texelFetch(t_depth, here, 0).r);
#else
    light *= accessibility_of_sample(here, 0.0);
#endif
#endif
#ifdef EMISSION
    vec4 emission = texelFetch(t_emission, here, 0);
    light *= emission.a;
#endif
#ifdef DIRECT
    vec4 direct = texelFetch(t_direct, here, 0);
    light += direct.rgb;
#endif
    vec3 color = albedo.rgb * light;
#ifdef SPECULAR
    color += albedo.a * direct.a;
#endif
#ifdef EMISSION
    color += emission.rgb;
#endif
#ifdef HDR
    o_color = vec4(color, 1.0);
#else
    o_color = vec4(encode_srgb(color), 1.0);
#endif
}
