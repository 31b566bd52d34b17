// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A surface that is lit while it is drawn, in linear light.
#include "passes/lighting.glsl"
#include "passes/surface.glsl"

#ifndef ENVIRONMENT
uniform vec3 u_ambient;
#endif

// What it sends to the camera through an opacity of alpha; `open` scales the ambient light. The
// highlight is not thinned by the opacity.
vec3 lit_surface(float open, float alpha) {
    vec3 n = surface_normal();
    vec3 albedo = surface_albedo();
#ifdef ENVIRONMENT
    vec3 light = irradiance(v_view_position, n);
#else
    vec3 light = u_ambient;
#endif
    light *= open;
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
    return albedo * light * alpha + added;
}
