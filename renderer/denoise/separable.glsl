// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A bilateral filter in two passes (after Bavoil and Sainz 2009, which the thesis used). The weights
// in the image are box4 convolved with itself, which leaves nothing of a pattern that repeats every
// four pixels. A neighbour counts as far as its depth follows the pixel's own plane: the reciprocal
// of depth is linear in the image on any plane, so a tilted one is smoothed like one that faces the
// camera. The tolerance is a fraction of the depth, so it scales with the units.
// ACROSS is the first pass: it reads accessibility and depth, and hands both on in one buffer.
#include "passes/shared_constants.h"

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

const int kReach = 3;            // taps to each side
const float kTolerance = 0.004;  // of the depth, for each pixel of distance

// Accessibility and reciprocal depth.
vec2 tap_at(ivec2 at) {
#ifdef ACROSS
    float depth_m = texelFetch(t_depth, at, 0).r;
    return vec2(texelFetch(t_accessibility, at, 0).r, 1.0 / max(depth_m, 1.0e-9));
#else
    return texelFetch(t_packed, at, 0).rg;
#endif
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
#ifdef ACROSS
    int last = textureSize(t_depth, 0).x - 1;
    int place = here.x;
#else
    int last = textureSize(t_packed, 0).y - 1;
    int place = here.y;
#endif
    vec2 taps[2 * kReach + 1];
    for (int i = -kReach; i <= kReach; ++i) {
        taps[i + kReach] = tap_at(here + kDirection * (clamp(place + i, 0, last) - place));
    }
    float w = taps[kReach].y;
    // Change of reciprocal depth along the direction: the smaller of the two one-sided differences,
    // so that a silhouette on one side does not count as slope.
    float before = w - taps[kReach - 1].y;
    float after = taps[kReach + 1].y - w;
    float slope = abs(before) < abs(after) ? before : after;
    float per_tolerance = 1.0 / (kTolerance * w);
    float sum = 4.0 * taps[kReach].x;
    float weights = 4.0;
    for (int i = -kReach; i <= kReach; ++i) {
        if (i == 0) continue;
        float distance_px = abs(float(i));
        float off = (taps[i + kReach].y - (w + slope * float(i))) * (per_tolerance / distance_px);
        float weight = (4.0 - distance_px) * max(0.0, 1.0 - off * off);
        bool counts = weight > 0.0 && place + i >= 0 && place + i <= last;
        sum += counts ? weight * taps[i + kReach].x : 0.0;
        weights += counts ? weight : 0.0;
    }
    // Division need not be exactly rounded: the mean of ones may come out as more than one.
    float mean = w > 1.0 / kBackgroundLimit_m ? min(sum / weights, 1.0) : 1.0;
#ifdef ACROSS
    o_packed = vec2(mean, w);
#else
    o_accessibility = mean;
#endif
}
