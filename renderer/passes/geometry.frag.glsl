// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The G-buffer of Jakobsen 2010, Table 1.
#include "passes/normal_codec.glsl"

in vec3 v_view_position;
in vec4 v_color;
#ifdef NORMAL
in vec3 v_normal;
#endif
#ifdef NORMAL_MAPPING
in vec4 v_tangent;
uniform sampler2D t_normal_map;
uniform int u_has_normal_map;
#endif
#if defined(TEXTURES) || defined(NORMAL_MAPPING)
in vec2 v_uv;
#endif
#ifdef TEXTURES
uniform sampler2D t_albedo_map;
uniform int u_has_albedo_map;
#endif
uniform vec3 u_albedo;
uniform float u_specular_intensity;
uniform float u_specular_power;

layout(location = 0) out vec4 o_albedo;
#ifdef NORMAL
layout(location = 1) out vec4 o_normal;
#endif
#ifdef DEPTH
layout(location = 2) out float o_depth_m;
#endif

#ifdef NORMAL
vec3 safe_normalize(vec3 v, vec3 otherwise) {
    float squared = dot(v, v);
    return squared > 1.0e-20 ? v * inversesqrt(squared) : otherwise;
}

vec3 surface_normal() {
    vec3 towards_camera = safe_normalize(-v_view_position, vec3(0.0, 0.0, 1.0));
    vec3 n = safe_normalize(v_normal, towards_camera);
    if (!gl_FrontFacing) n = -n;
#ifdef NORMAL_MAPPING
    if (u_has_normal_map != 0) {
        // The bitangent follows from the handedness; a degenerate tangent leaves the normal alone.
        vec3 t = v_tangent.xyz - n * dot(n, v_tangent.xyz);
        if (dot(t, t) > 1.0e-12) {
            t = normalize(t);
            vec3 b = cross(n, t) * v_tangent.w;
            vec3 m = texture(t_normal_map, v_uv).xyz * (255.0 / 127.0) - 128.0 / 127.0;
            n = safe_normalize(t * m.x + b * m.y + n * m.z, n);
        }
    }
#endif
    return n;
}
#endif

void main() {
    vec3 albedo = u_albedo * v_color.rgb;
#ifdef TEXTURES
    if (u_has_albedo_map != 0) albedo *= texture(t_albedo_map, v_uv).rgb;
#endif
    o_albedo = vec4(albedo, u_specular_intensity);
#ifdef NORMAL
    o_normal = vec4(encode_normal(surface_normal()), u_specular_power / 255.0);
#endif
#ifdef DEPTH
    o_depth_m = -v_view_position.z;
#endif
}
