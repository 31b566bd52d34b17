// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Rays through a scene's triangles, from storage buffers (reference/ray_tree.h). Every triangle stops a
// ray from both sides but where backs are said to be open; cut-outs have their holes.
#include "passes/shared_constants.h"

layout(std430, binding = 0) readonly restrict buffer RayNodes { uvec4 ray_nodes[]; };
layout(std430, binding = 1) readonly restrict buffer RayTriangles { uvec4 ray_triangles[]; };
layout(std430, binding = 2) readonly restrict buffer RayCutOuts { uvec4 ray_cut_outs[]; };
layout(std430, binding = 3) readonly restrict buffer RayAlpha { uint ray_alpha[]; };

const uint kLeaf = 1u << 31;
const int kCountShift = 28;
const int kStack = 64;
const float kWider = 1.0000004;  // of the far side of a box: what rounding may take from it

float alpha_texel(uvec4 image, vec2 at) {
    vec2 size = vec2(image.yz);
    uvec2 cell = uvec2(at - size * floor(at / size));
    uint i = image.x + min(cell.y, image.z - 1u) * image.y + min(cell.x, image.y - 1u);
    return float(ray_alpha[i >> 2] >> (8u * (i & 3u)) & 255u) / 255.0;
}

// Whether a cut-out has a surface at those weights of its second and third corner.
bool covers(uint number, float u, float v) {
    uvec4 first = ray_cut_outs[3u * number];
    uvec4 second = ray_cut_outs[3u * number + 1u];
    uvec4 image = ray_cut_outs[3u * number + 2u];
    float opacity = uintBitsToFloat(second.z);
    float cutoff = uintBitsToFloat(second.w);
    if (image.y == 0u) return opacity >= cutoff;
    vec2 uv = (1.0 - u - v) * uintBitsToFloat(first.xy) + u * uintBitsToFloat(first.zw) +
              v * uintBitsToFloat(second.xy);
    vec2 at = uv * vec2(image.yz) - 0.5;
    vec2 corner = floor(at);
    vec2 f = at - corner;
    float upper = mix(alpha_texel(image, corner), alpha_texel(image, corner + vec2(1.0, 0.0)), f.x);
    float lower = mix(alpha_texel(image, corner + vec2(0.0, 1.0)),
                      alpha_texel(image, corner + vec2(1.0)), f.x);
    return mix(upper, lower, f.y) * opacity >= cutoff;
}

struct Met {
    float at;     // in lengths of the ray's direction; where it is the ray's end, nothing
    vec3 across;  // of the triangle, twice its area long
};

// Moeller and Trumbore 1997.
void meet_triangle(uint number, vec3 from, vec3 towards, float near, bool backs_open, inout Met met) {
    uvec4 a = ray_triangles[3u * number];
    uvec4 b = ray_triangles[3u * number + 1u];
    vec3 edge = uintBitsToFloat(b.xyz);
    vec3 other = uintBitsToFloat(ray_triangles[3u * number + 2u].xyz);
    vec3 p = cross(towards, other);
    float volume = dot(edge, p);
    if (volume == 0.0) return;
    // The triangle's normal is across; what faces away from the ray has a volume below 0.
    if (backs_open && b.w != 0u && volume <= 0.0) return;
    float inverse = 1.0 / volume;
    vec3 s = from - uintBitsToFloat(a.xyz);
    vec3 q = cross(s, edge);
    float u = dot(s, p) * inverse;
    float v = dot(towards, q) * inverse;
    float t = dot(other, q) * inverse;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > near && t < met.at)) return;
    if (a.w != 0u && !covers(a.w - 1u, u, v)) return;
    met.at = t;
    met.across = cross(edge, other);
}

// Where a ray enters a box, or beyond any ray's end where it does not.
float enters(uvec3 low, uvec3 high, vec3 from, vec3 inverse, float near, float far) {
    vec3 a = (uintBitsToFloat(low) - from) * inverse;
    vec3 b = (uintBitsToFloat(high) - from) * inverse;
    vec3 first = min(a, b);
    vec3 last = max(a, b);
    float t_in = max(max(first.x, first.y), max(first.z, near));
    float t_out = min(min(last.x, last.y), last.z) * kWider;
    return t_in <= min(t_out, far) ? t_in : kBackgroundDepth_m;
}

// The nearest triangle that a ray meets between near and far, or with `any` some one.
Met cast_ray(vec3 from, vec3 towards, float near, float far, bool any, bool backs_open) {
    Met met = Met(far, vec3(0.0));
    vec3 sign = vec3(towards.x < 0.0 ? -1.0 : 1.0, towards.y < 0.0 ? -1.0 : 1.0,
                     towards.z < 0.0 ? -1.0 : 1.0);
    vec3 inverse = 1.0 / (sign * max(abs(towards), 1.0e-18));
    uint stack[kStack];
    int height = 0;
    uint node = 0u;
    while (true) {
        if ((node & kLeaf) != 0u) {
            uint first = node & ((1u << kCountShift) - 1u);
            uint end = first + (node >> kCountShift & 7u);
            for (uint i = first; i < end; ++i) {
                meet_triangle(i, from, towards, near, backs_open, met);
            }
            if (any && met.at < far) return met;
            if (height == 0) return met;
            node = stack[--height];
            continue;
        }
        uvec4 a = ray_nodes[4u * node];
        uvec4 b = ray_nodes[4u * node + 1u];
        uvec4 c = ray_nodes[4u * node + 2u];
        uvec4 d = ray_nodes[4u * node + 3u];
        float first = enters(a.xyz, b.xyz, from, inverse, near, met.at);
        float second = enters(c.xyz, d.xyz, from, inverse, near, met.at);
        bool swapped = second < first;
        float nearer = min(first, second);
        if (nearer >= kBackgroundDepth_m) {
            if (height == 0) return met;
            node = stack[--height];
            continue;
        }
        node = swapped ? b.w : a.w;
        if (max(first, second) < kBackgroundDepth_m && height < kStack) {
            stack[height++] = swapped ? a.w : b.w;
        }
    }
    return met;
}
