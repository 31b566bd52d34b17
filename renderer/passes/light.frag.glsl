// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Light on every surface, apart from ambient occlusion: the two images of a pair share it.
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"

uniform sampler2D t_normal;
uniform mat3 u_world_from_view;  // rotation only
#ifdef ENVIRONMENT
uniform vec3 u_irradiance_sh[9];
layout(location = 0) out vec4 o_ambient;
#endif
#ifdef LIGHTS
uniform vec3 u_towards_light[LIGHTS];       // view space, unit length
uniform vec3 u_light_irradiance[LIGHTS];
uniform mat4 u_shadow_from_view[LIGHTS];    // to [0, 1] in u, v and depth
uniform float u_shadow_texel_m;
uniform sampler2DArrayShadow t_shadow;
layout(location = 1) out vec4 o_direct;     // diffuse light / pi, specular light
#endif

#ifdef ENVIRONMENT
// Ramamoorthi and Hanrahan 2001, equation 3; the coefficients already hold the cosine.
vec3 irradiance(vec3 n) {
    vec3 sum = u_irradiance_sh[0] * 0.282095;
    sum += (u_irradiance_sh[1] * n.y + u_irradiance_sh[2] * n.z + u_irradiance_sh[3] * n.x) *
           0.488603;
    sum += (u_irradiance_sh[4] * (n.x * n.y) + u_irradiance_sh[5] * (n.y * n.z) +
            u_irradiance_sh[7] * (n.x * n.z)) *
           1.092548;
    sum += u_irradiance_sh[6] * (0.315392 * (3.0 * n.z * n.z - 1.0));
    sum += u_irradiance_sh[8] * (0.546274 * (n.x * n.x - n.y * n.y));
    return max(sum, vec3(0.0));
}
#endif

#ifdef LIGHTS
// Share of the light that arrives: a tent over 5x5 texels, each compared with bilinear weights. The
// point is moved along the normal by what the filter reaches, which keeps lit surfaces free of acne
// at any slope.
float light_visibility(int light, vec3 p, vec3 n, float cosine) {
    float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    vec3 lifted = p + n * (u_shadow_texel_m * (0.5 + 3.0 * sine));
    vec3 at = (u_shadow_from_view[light] * vec4(lifted, 1.0)).xyz;
    vec2 texel = 1.0 / vec2(textureSize(t_shadow, 0).xy);
    float sum = 0.0;
    float weights = 0.0;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            float weight = float((3 - abs(x)) * (3 - abs(y)));
            sum += weight * texture(t_shadow, vec4(at.xy + vec2(x, y) * texel, light, at.z));
            weights += weight;
        }
    }
    return sum / weights;
}
#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 code = texelFetch(t_normal, here, 0);
    vec3 n = decode_normal(code.xyz);
#ifdef ENVIRONMENT
    o_ambient = vec4(irradiance(u_world_from_view * n), 1.0);
#endif
#ifdef LIGHTS
    vec3 p = view_ray(gl_FragCoord.xy / u_size) * texelFetch(t_depth, here, 0).r;
    vec3 diffuse = vec3(0.0);
    float specular = 0.0;
    for (int i = 0; i < LIGHTS; ++i) {
        float cosine = dot(n, u_towards_light[i]);
        if (!(cosine > 0.0)) continue;
        float visibility = light_visibility(i, p, n, cosine);
        vec3 arriving = u_light_irradiance[i] * (cosine * visibility * 0.31830988618);
        diffuse += arriving;
#ifdef SPECULAR
        // Blinn-Phong, normalised (Akenine-Moller, Haines and Hoffman 2008, section 7.5.7).
        float power = max(code.a * 255.0, 1.0);
        vec3 towards_camera = normalize(-p);
        vec3 between = u_towards_light[i] + towards_camera;
        float squared = dot(between, between);
        if (squared > 1.0e-12) {
            float lobe = pow(max(dot(n, between * inversesqrt(squared)), 1.0e-6), power);
            specular += dot(arriving, vec3(0.2126, 0.7152, 0.0722)) * lobe * (power + 8.0) / 8.0;
        }
#endif
    }
    o_direct = vec4(diffuse, specular);
#endif
}
