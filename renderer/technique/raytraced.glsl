// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What reference/buffer_rays.cpp computes on the processor, in the same way: the face that a pixel
// shows, and rays from it, on the same points of the hemisphere.
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"
#include "technique/rays.glsl"

uniform sampler2D t_normal;
uniform mat3 u_world_from_view;
uniform vec3 u_eye_m;  // relative to the triangles' origin
uniform float p_radius_m;

const float kOffset = 3.0e-5;          // of the depth
const float kTriangleOffset = 4.0e-7;  // of the triangle's size
const float kProbe = 1.0e-3;           // of the depth, before and behind it
const float kQuarterPi = 0.785398163397448;

// Sums and products of 64 bits; x is the lower half.
uvec2 sum64(uvec2 a, uvec2 b) {
    uint carry;
    uint low = uaddCarry(a.x, b.x, carry);
    return uvec2(low, a.y + b.y + carry);
}
uvec2 product64(uvec2 a, uvec2 b) {
    uint high, low;
    umulExtended(a.x, b.x, high, low);
    return uvec2(low, high + a.x * b.y + a.y * b.x);
}
// v ^ v >> n, n below 32.
uvec2 folded64(uvec2 v, int n) { return v ^ uvec2(v.x >> n | v.y << (32 - n), v.y >> n); }

// SplitMix64's finaliser (reference/sampler.h, mixed_bits).
uvec2 mixed_bits(uvec2 v) {
    v = sum64(v, uvec2(0x7f4a7c15u, 0x9e3779b9u));
    v = product64(folded64(v, 30), uvec2(0x1ce4e5b9u, 0xbf58476du));
    v = product64(folded64(v, 27), uvec2(0x133111ebu, 0x94d049bbu));
    return folded64(v, 31);
}

// Owen's scramble by Laine and Karras 2011, constants of Burley 2020; see reference/sampler.cpp.
uint owen_hash(uint reversed, uint seed) {
    uint v = reversed + seed;
    v ^= v * 0x6c50b47cu;
    v ^= v * 0xb82f1e52u;
    v ^= v * 0xc7afe638u;
    v ^= v * 0x8d22f6e6u;
    return bitfieldReverse(v);
}

float signed_unit(uint bits) { return float(int(bits >> 8) - (1 << 23)) * exp2(-23.0) + exp2(-24.0); }

uint sobol_second(uint index) {
    uint value = 0u;
    for (uint direction = 0x80000000u; index != 0u; index >>= 1) {
        if ((index & 1u) != 0u) value ^= direction;
        direction ^= direction >> 1;
    }
    return value;
}

// Direction number k of a block of 4x4 pixels, about +Z with density cos / pi.
vec3 direction_of(uint k, uvec2 seeds) {
    float a = signed_unit(owen_hash(k, seeds.x));
    float b = signed_unit(owen_hash(bitfieldReverse(sobol_second(k)), seeds.y));
    bool wide = abs(a) > abs(b);
    float r = wide ? a : b;
    float phi = kQuarterPi * ((wide ? b : a) / r);
    float x = r * (wide ? cos(phi) : sin(phi));
    float y = r * (wide ? sin(phi) : cos(phi));
    return vec3(x, y, sqrt((1.0 - r) * (1.0 + r)));
}

// Duff et al. 2017, equation 6.
mat3 frame_of(vec3 n) {
    float sign = n.z >= 0.0 ? 1.0 : -1.0;
    float s = -1.0 / (sign + n.z);
    float t = n.x * n.y * s;
    return mat3(vec3(1.0 + sign * n.x * n.x * s, sign * t, -sign * n.x),
                vec3(t, sign + n.y * n.y * s, -n.y), n);
}

float accessibility(vec2 uv, float z) {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec3 ray = u_world_from_view * view_ray(uv);
    vec3 n = u_world_from_view * decode_normal(texelFetch(t_normal, here, 0).xyz);
    float offset_m = kOffset * (z + length(u_eye_m));
    float end = z * (1.0 + kProbe);
    Met face = cast_ray(u_eye_m, ray, z * (1.0 - kProbe), end, false, true);
    float squared = dot(face.across, face.across);
    if (face.at < end && squared > 0.0) {
        z = face.at;
        n = face.across * ((dot(face.across, ray) > 0.0 ? -1.0 : 1.0) * inversesqrt(squared));
        offset_m = max(offset_m, kTriangleOffset * sqrt(sqrt(squared)));
    }
    mat3 about = frame_of(n);
    vec3 from = u_eye_m + z * ray + offset_m * n;
    uvec2 seeds = mixed_bits(uvec2(here.x >> 2, here.y >> 2));
    uint part = uint(here.x & 1 | (here.y & 1) << 1 | (here.x & 2) << 1 | (here.y & 2) << 2);
    int met = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 towards = about * direction_of(part * uint(SAMPLES) + uint(i), seeds);
        if (cast_ray(from, towards, 0.0, p_radius_m, true, false).at < p_radius_m) ++met;
    }
    return 1.0 - float(met) / float(SAMPLES);
}

#include "passes/accessibility.glsl"
