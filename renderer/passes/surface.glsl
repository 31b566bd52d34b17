// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A material at a fragment: colour, coverage, normal and the light it sends out. Each part is there
// where its define is: UV, TEXTURES, NORMAL, NORMAL_MAPPING, ROUGHNESS, EMISSION.
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
#ifdef UV
in vec2 v_uv;
#endif
#ifdef TEXTURES
uniform sampler2D t_albedo_map;
uniform int u_has_albedo_map;
#endif
#ifdef ROUGHNESS
uniform sampler2D t_roughness_map;  // green: roughness, blue: metalness
uniform int u_has_roughness_map;
uniform float u_roughness;
uniform float u_metalness;
#endif
#ifdef EMISSION
uniform sampler2D t_emissive_map;
uniform int u_has_emissive_map;
uniform sampler2D t_occlusion_map;
uniform float u_occlusion_strength;  // 0 where there is no map
uniform vec3 u_emissive;
#endif
uniform vec3 u_albedo;
uniform float u_opacity;
uniform float u_specular_intensity;
uniform float u_specular_power;

vec3 surface_albedo() {
    vec3 albedo = u_albedo * v_color.rgb;
#ifdef TEXTURES
    if (u_has_albedo_map != 0) albedo *= texture(t_albedo_map, v_uv).rgb;
#endif
    return albedo;
}

// From the finest level, so that holes are where a ray through the pixel's middle finds them.
float surface_alpha() {
    float alpha = u_opacity * v_color.a;
#ifdef TEXTURES
    if (u_has_albedo_map != 0) alpha *= textureLod(t_albedo_map, v_uv, 0.0).a;
#endif
    return alpha;
}

// Intensity, [0, 1], and exponent, [1, 255], of the highlight. Roughness becomes an exponent as in
// scene/surface_conversion.h.
vec2 surface_specular(vec3 albedo) {
    vec2 specular = vec2(u_specular_intensity, u_specular_power);
#ifdef ROUGHNESS
    if (u_has_roughness_map != 0) {
        vec2 map = texture(t_roughness_map, v_uv).gb * vec2(u_roughness, u_metalness);
        float metal = dot(albedo, vec3(0.2126, 0.7152, 0.0722)) * (1.0 - map.x);
        float alpha = max(map.x * map.x, 1.0e-4);
        specular = vec2(clamp(mix(u_specular_intensity, metal, map.y), 0.0, 1.0),
                        clamp(2.0 / (alpha * alpha) - 2.0, 1.0, 255.0));
    }
#endif
    return specular;
}

#ifdef EMISSION
// Light sent out, and baked accessibility.
vec4 surface_emission() {
    vec3 emission = u_emissive;
    if (u_has_emissive_map != 0) emission *= texture(t_emissive_map, v_uv).rgb;
    float open = 1.0;
    if (u_occlusion_strength > 0.0) {
        open = 1.0 + u_occlusion_strength * (texture(t_occlusion_map, v_uv).r - 1.0);
    }
    return vec4(emission, open);
}
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
