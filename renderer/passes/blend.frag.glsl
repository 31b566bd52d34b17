// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A surface that is seen through, lit as the others are, over what lies behind it (linear light). The
// highlight is not thinned by the opacity.
#include "passes/lighting.glsl"
#include "passes/surface.glsl"

#ifdef ACCESSIBILITY
#include "passes/accessibility_of_sample.glsl"
uniform float u_occluding_opacity;
#endif
#ifndef ENVIRONMENT
uniform vec3 u_ambient;
#endif
layout(location = 0) out vec4 o_color;

void main() {
    float alpha = clamp(surface_alpha(), 0.0, 1.0);
    vec3 n = surface_normal();
    vec3 albedo = surface_albedo();
#ifdef ENVIRONMENT
    vec3 light = irradiance(u_world_from_view * n);
#else
    vec3 light = u_ambient;
#endif
#ifdef ACCESSIBILITY
    if (alpha >= u_occluding_opacity) {
        light *= accessibility_of_sample(ivec2(gl_FragCoord.xy), -v_view_position.z);
    }
#endif
    vec3 added = vec3(0.0);
#ifdef EMISSION
    vec4 emission = surface_emission();
    light *= emission.a;
    added += emission.rgb * alpha;
#endif
#ifdef DIRECT
    vec2 specular = surface_specular(albedo);
    vec4 direct = direct_light(v_view_position, n, specular.y);
    light += direct.rgb;
#ifdef SPECULAR
    added += specular.x * direct.a;
#endif
#endif
    o_color = vec4(albedo * light * alpha + added, alpha);
}
