// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What techniques that march through the image along slices share. A slice is the plane of the view
// ray and a direction of the image; a sample's place in it is two numbers, along the direction and
// along the ray. A texel's depth is known in its middle and is carried over to the sample's place on
// the slope of P's own plane: on a plane every sample lies on it, at any tilt, or below it where the
// slope is steep enough to draw near what is far behind and is held back.
#include "passes/view.glsl"
#include "passes/normal_codec.glsl"

// A program that is made for one of their values has it as a define.
#ifndef p_step_spread
uniform float p_step_spread;
#endif
#ifndef p_power
uniform float p_power;
#endif
uniform sampler2D t_normal;
uniform sampler2D t_turns;  // NOISE_SIZE x NOISE_SIZE: cosine and sine of the first slice, jitter

const int kSteps = FAN_STEPS;  // of a slice on each side
const float kLeastCosine = 1.0e-3;  // of the normal against the ray to the camera

struct Surface {
    vec2 px;         // in the image, in pixels
    float z;
    vec3 ray;        // z = -1
    float length;    // of the ray
    float squared_length;
    vec3 n;
    float facing;    // cosine of n against the ray to the camera, at least kLeastCosine
    float pixel;     // view x or y per metre of depth and pixel
    vec2 slope_per_m;  // change of 1 / z per pixel on P's plane
};

Surface surface_at(vec2 uv, float z) {
    Surface p;
    p.px = gl_FragCoord.xy;
    p.z = z;
    p.ray = ray_to(uv, ivec2(gl_FragCoord.xy), z);
    p.squared_length = dot(p.ray, p.ray);
    p.length = sqrt(p.squared_length);
    p.n = decode_normal(texelFetch(t_normal, ivec2(gl_FragCoord.xy), 0).xyz);
    p.facing = max(-dot(p.n, p.ray) / p.length, kLeastCosine);
    p.pixel = 2.0 * u_ray_scale.y / u_size.y;
    p.slope_per_m = p.n.xy * (-p.pixel / (p.facing * p.length * z));
    return p;
}

struct Slice {
    vec2 direction;  // in the image, unit length
    float along;     // of the direction on the ray
    float across;    // cosine of n against the slice's direction at right angles to the ray
    float sine;      // of the angle of the projected normal against the ray to the camera
    float cosine;
};

Slice slice_of(Surface p, vec2 direction) {
    Slice s;
    s.direction = direction;
    s.along = dot(direction, p.ray.xy);
    float part = s.along / p.length;
    s.across = (dot(p.n.xy, direction) + p.facing * part) * inversesqrt(1.0 - part * part);
    float inverse = inversesqrt(p.facing * p.facing + s.across * s.across);
    s.sine = s.across * inverse;
    s.cosine = p.facing * inverse;
    return s;
}

struct Sample {
    bool seen;      // false outside the image and where nothing is
    float there;    // its depth
    float deeper;   // than P, in m
    float cosine;   // of the angle to the ray to the camera
    float squared;  // of the distance from P, in m
};

// Fills in where a point of that depth, `distance_px` along the direction, lies in the slice.
void place(Surface p, Slice s, float distance_px, inout Sample q) {
    float beside = distance_px * p.pixel * q.there;
    float with_ray = beside * s.along + q.deeper * p.squared_length;
    q.squared = max(beside * beside + q.deeper * (beside * s.along + with_ray), 1.0e-36);
    q.cosine = -with_ray * inversesqrt(q.squared * p.squared_length);
}

// A texel's surface of depth z, carried over to a place in pixels that lies within it and
// `distance_px` along the slice's direction.
Sample carried(Surface p, Slice s, float distance_px, vec2 px, ivec2 texel, float z) {
    Sample q;
    q.seen = z < kBackgroundLimit_m;
    float change = clamp(z * dot(p.slope_per_m, px - (vec2(texel) + 0.5)), -0.9, 0.5);
    q.there = z / (1.0 + change);
    q.deeper = (z - p.z) - q.there * change;
    place(p, s, distance_px, q);
    return q;
}

bool in_image(vec2 px) {
    return all(greaterThanEqual(px, vec2(0.0))) && all(lessThan(px, u_size));
}

// The surface `distance_px` pixels along the slice's direction; negative on the other side.
Sample sample_at(Surface p, Slice s, float distance_px) {
    vec2 px = p.px + s.direction * distance_px;
    // Without branches: a fetch that isn't used reads P's own texel.
    bool inside = in_image(px);
    ivec2 texel = ivec2(inside ? px : p.px);
    Sample q = carried(p, s, distance_px, px, texel, texelFetch(t_depth, texel, 0).r);
    q.seen = q.seen && inside;
    return q;
}

// How far along a slice sample i of kSteps lies, in pixels; at least 1, so that none is on P.
float distance_of(int i, float jitter, float radius_px, float spread) {
    float u = (float(i) + jitter) * (1.0 / float(kSteps));
    float squared = u * mix(1.0, u, min(spread, 1.0));
    return 1.0 + radius_px * squared * mix(1.0, u, max(spread - 1.0, 0.0));
}

// Abramowitz and Stegun 1964, 4.4.46: within 2e-8, and rounding.
float fast_acos(float x) {
    float y = abs(x);
    float series = -0.0170881256 + y * (0.0066700901 + y * -0.0012624911);
    series = 0.0889789874 + y * (-0.0501743046 + y * (0.0308918810 + y * series));
    float a = sqrt(max(1.0 - y, 0.0)) * (1.5707963050 + y * (-0.2145988016 + y * series));
    return x < 0.0 ? 3.14159265359 - a : a;
}

// Twice the cosine-weighted integral over a slice's angles from the ray to the camera to one with
// cosine c, on the side where the normal's cosines are `facing` and `across` (Jimenez et al. 2016, in
// which the two are the projected normal's length times cosine and sine of its angle).
float arc(float facing, float across, float c) {
    float squared = 1.0 - c * c;
    return facing * squared + across * (fast_acos(c) - c * sqrt(max(squared, 0.0)));
}
