// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Light that arrives at a point of a surface, all in view space. ENVIRONMENT, with it
// IRRADIANCE_GRID; LIGHTS n, POINT_LIGHTS n, SPECULAR; DIRECT where there is a light of either kind.
uniform mat3 u_world_from_view;  // rotation only
#ifdef ENVIRONMENT
// Ramamoorthi and Hanrahan 2001, equation 3, along a normal in the world; the coefficients already
// hold the cosine.
vec3 irradiance_of(vec3 sh[9], vec3 n) {
    vec3 sum = sh[0] * 0.282095;
    sum += (sh[1] * n.y + sh[2] * n.z + sh[3] * n.x) * 0.488603;
    sum += (sh[4] * (n.x * n.y) + sh[5] * (n.y * n.z) + sh[7] * (n.x * n.z)) * 1.092548;
    sum += sh[6] * (0.315392 * (3.0 * n.z * n.z - 1.0));
    sum += sh[8] * (0.546274 * (n.x * n.x - n.y * n.y));
    return max(sum, vec3(0.0));
}
#ifdef IRRADIANCE_GRID
uniform sampler3D t_probes;      // seven layers of all probes, four numbers of each
uniform mat4 u_probe_from_view;  // to texels of a layer: the first probe stands at 0.5
uniform vec3 u_probe_count;

// One step of the grid further along the normal: no probe behind a surface has any part in it.
vec3 irradiance(vec3 p, vec3 n) {
    vec3 along = u_world_from_view * n;
    vec3 at = (u_probe_from_view * vec4(p, 1.0)).xyz + along;
    at = clamp(at, vec3(0.5), u_probe_count - 0.5);
    vec3 texel = 1.0 / (u_probe_count * vec3(1.0, 1.0, 7.0));
    vec4 c[7];
    for (int i = 0; i < 7; ++i) {
        c[i] = textureLod(t_probes, vec3(at.xy, at.z + float(i) * u_probe_count.z) * texel, 0.0);
    }
    vec3 sh[9] = vec3[9](c[0].xyz, vec3(c[0].w, c[1].xy), vec3(c[1].zw, c[2].x), c[2].yzw,
                         c[3].xyz, vec3(c[3].w, c[4].xy), vec3(c[4].zw, c[5].x), c[5].yzw,
                         c[6].xyz);
    return irradiance_of(sh, along) / c[6].w;  // the weights that the numbers hold
}
#else
uniform vec3 u_irradiance_sh[9];

vec3 irradiance(vec3 p, vec3 n) { return irradiance_of(u_irradiance_sh, u_world_from_view * n); }
#endif
#endif

#ifdef DIRECT
// Share of the light that arrives: a tent over 5x5 texels, each compared with bilinear weights.
float filtered_visibility(sampler2DArrayShadow map, int layer, vec3 at) {
    vec2 texel = 1.0 / vec2(textureSize(map, 0).xy);
    float sum = 0.0;
    float weights = 0.0;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            float weight = float((3 - abs(x)) * (3 - abs(y)));
            sum += weight * texture(map, vec4(at.xy + vec2(x, y) * texel, layer, at.z));
            weights += weight;
        }
    }
    return sum / weights;
}

// The point is moved along the normal by what the filter reaches, which keeps lit surfaces free of
// acne at any slope.
vec3 lifted(vec3 p, vec3 n, float cosine, float texel_m) {
    float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    return p + n * (texel_m * (0.5 + 3.0 * sine));
}

// Adds one light's part to diffuse light / pi (rgb) and specular light (a).
void add_light(inout vec4 sum, vec3 p, vec3 n, vec3 towards_light, vec3 arriving, float power) {
    sum.rgb += arriving;
#ifdef SPECULAR
    // Blinn-Phong, normalised (Akenine-Moller, Haines and Hoffman 2008, section 7.5.7).
    vec3 between = towards_light + normalize(-p);
    float squared = dot(between, between);
    if (squared > 1.0e-12) {
        float lobe = pow(max(dot(n, between * inversesqrt(squared)), 1.0e-6), power);
        sum.a += dot(arriving, vec3(0.2126, 0.7152, 0.0722)) * lobe * (power + 8.0) / 8.0;
    }
#endif
}
#endif

#ifdef LIGHTS
uniform vec3 u_towards_light[LIGHTS];       // unit length
uniform vec3 u_light_irradiance[LIGHTS];
uniform mat4 u_shadow_from_view[LIGHTS];    // to [0, 1] in u, v and depth
uniform float u_shadow_texel_m;
uniform sampler2DArrayShadow t_shadow;

void add_directional_light(inout vec4 sum, int i, vec3 p, vec3 n, float power) {
    float cosine = dot(n, u_towards_light[i]);
    if (!(cosine > 0.0)) return;
    vec4 at = u_shadow_from_view[i] * vec4(lifted(p, n, cosine, u_shadow_texel_m), 1.0);
    float visibility = filtered_visibility(t_shadow, i, at.xyz);
    vec3 arriving = u_light_irradiance[i] * (cosine * visibility * 0.31830988618);
    add_light(sum, p, n, u_towards_light[i], arriving, power);
}
#endif

#ifdef POINT_LIGHTS
uniform vec3 u_point_position[POINT_LIGHTS];
uniform vec3 u_point_intensity[POINT_LIGHTS];
uniform vec3 u_point_axis[POINT_LIGHTS];          // unit length
uniform vec3 u_point_cone[POINT_LIGHTS];          // cosines of the inner and outer half angle, range in m
uniform mat4 u_point_shadow_from_view[6 * POINT_LIGHTS];
uniform float u_point_shadow_texel;               // texel width at 1 m, in m
uniform sampler2DArrayShadow t_point_shadow;

// +X -X +Y -Y +Z -Z for 0 to 5.
int side_of(vec3 d) {
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x >= 0.0 ? 0 : 1;
    if (a.y >= a.z) return d.y >= 0.0 ? 2 : 3;
    return d.z >= 0.0 ? 4 : 5;
}

void add_point_light(inout vec4 sum, int i, vec3 p, vec3 n, float power) {
    vec3 towards = u_point_position[i] - p;
    float squared = dot(towards, towards);
    float distance_m = sqrt(squared);
    if (!(squared > 1.0e-12) || distance_m > u_point_cone[i].z) return;
    towards /= distance_m;
    float cosine = dot(n, towards);
    if (!(cosine > 0.0)) return;
    // A whole sphere has both cosines at -1: nothing is lost.
    float cone = 1.0;
    if (u_point_cone[i].y > -1.0) {
        cone = smoothstep(u_point_cone[i].y, max(u_point_cone[i].x, u_point_cone[i].y + 1.0e-4),
                          dot(-towards, u_point_axis[i]));
    }
    if (!(cone > 0.0)) return;
    vec3 from = lifted(p, n, cosine, u_point_shadow_texel * distance_m);
    int layer = 6 * i + side_of(u_world_from_view * (from - u_point_position[i]));
    vec4 at = u_point_shadow_from_view[layer] * vec4(from, 1.0);
    float visibility = filtered_visibility(t_point_shadow, layer, at.xyz / at.w);
    vec3 arriving =
        u_point_intensity[i] * (cone * cosine * visibility * 0.31830988618 / max(squared, 1.0e-4));
    add_light(sum, p, n, towards, arriving, power);
}
#endif

#ifdef DIRECT
vec4 direct_light(vec3 p, vec3 n, float specular_power) {
    vec4 sum = vec4(0.0);
    float power = max(specular_power, 1.0);
#ifdef LIGHTS
    for (int i = 0; i < LIGHTS; ++i) add_directional_light(sum, i, p, n, power);
#endif
#ifdef POINT_LIGHTS
    for (int i = 0; i < POINT_LIGHTS; ++i) add_point_light(sum, i, p, n, power);
#endif
    return sum;
}
#endif
