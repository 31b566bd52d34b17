// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What techniques that sample a disc of the image share: points of the disc, turned another way in
// every pixel, around a pixel whose depth says how large the radius is.
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"
#ifndef DISC
#error the points of the disc must be defined
#endif

uniform float p_radius_m;
uniform float p_reach;
uniform sampler2D t_normal;
uniform sampler2D t_turns;  // NOISE_SIZE x NOISE_SIZE: cosine and sine

const vec2 kDisc[] = DISC;

vec3 normal_at(ivec2 texel) { return decode_normal(texelFetch(t_normal, texel, 0).xyz); }

// View x or y per metre of depth and pixel.
float pixel_size() { return 2.0 * u_ray_scale.y / u_size.y; }

// The texel of point i; negative outside the image.
ivec2 disc_texel(int i, float z) {
    vec2 turn = texelFetch(t_turns, ivec2(gl_FragCoord.xy) % NOISE_SIZE, 0).xy;
    float radius_px = p_radius_m * p_reach / (z * pixel_size());
    vec2 d = kDisc[i];
    vec2 px = gl_FragCoord.xy +
              vec2(turn.x * d.x - turn.y * d.y, turn.x * d.y + turn.y * d.x) * radius_px;
    bool inside = all(greaterThanEqual(px, vec2(0.0))) && all(lessThan(px, u_size));
    return inside ? ivec2(px) : ivec2(-1);
}
