// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Filion and McNaughton 2008: a Gaussian in two passes that leaves out neighbours whose depth or normal
// differs by more than a threshold from the pixel's own. Here a depth differs by how far it lies off
// the pixel's own plane, on which the reciprocal of depth is linear in the image, as a share of the
// depth: a tilted surface is smoothed like one that faces the camera, in any unit. The deviation is wide
// enough to leave a hundredth of a pattern that repeats every four pixels. ACROSS is the first pass.
#include "passes/normal_codec.glsl"
#include "passes/shared_constants.h"

uniform sampler2D t_normal;
#ifdef ACROSS
uniform sampler2D t_accessibility;
uniform sampler2D t_depth;
layout(location = 0) out vec2 o_packed;  // accessibility, reciprocal depth
const ivec2 kDirection = ivec2(1, 0);
#else
uniform sampler2D t_packed;
layout(location = 0) out float o_accessibility;
const ivec2 kDirection = ivec2(0, 1);
#endif

const int kReach = 6;
// exp(-i^2 / (2 sigma^2)) for a standard deviation of 2 pixels.
const float kWeights[kReach + 1] = float[](1.0, 0.882496903, 0.60653066, 0.324652467, 0.135335283,
                                           0.0439369336, 0.0111089965);
const float kTolerance = 0.004;  // of the depth, for each pixel of distance
const float kLeastCosine = 0.9;  // between normals

// Accessibility and reciprocal depth.
vec2 tap_at(ivec2 at) {
#ifdef ACROSS
    float depth_m = texelFetch(t_depth, at, 0).r;
    return vec2(texelFetch(t_accessibility, at, 0).r, 1.0 / max(depth_m, 1.0e-9));
#else
    return texelFetch(t_packed, at, 0).rg;
#endif
}

vec3 normal_at(ivec2 at) { return decode_normal(texelFetch(t_normal, at, 0).xyz); }

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(t_normal, 0) - 1;
    vec3 n = normal_at(here);
    vec2 own = tap_at(here);
    float w = own.y;
    float before = w - tap_at(max(here - kDirection, ivec2(0))).y;
    float after = tap_at(min(here + kDirection, last)).y - w;
    float slope = abs(before) < abs(after) ? before : after;
    float sum = own.x;
    float weights = 1.0;
    for (int i = -kReach; i <= kReach; ++i) {
        ivec2 at = here + kDirection * i;
        if (i == 0 || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
        vec2 tap = tap_at(at);
        float distance_px = abs(float(i));
        bool same = abs(tap.y - (w + slope * float(i))) <= kTolerance * w * distance_px &&
                    dot(normal_at(at), n) >= kLeastCosine;
        float weight = same ? kWeights[abs(i)] : 0.0;
        sum += weight * tap.x;
        weights += weight;
    }
    // Division need not be exactly rounded: the mean of ones may come out as more than one.
    float mean = w > 1.0 / kBackgroundLimit_m ? min(sum / weights, 1.0) : 1.0;
#ifdef ACROSS
    o_packed = vec2(mean, w);
#else
    o_accessibility = mean;
#endif
}
