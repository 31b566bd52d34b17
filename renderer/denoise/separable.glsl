// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A bilateral filter in two passes (after Bavoil and Sainz 2009, which the thesis used). The weights
// in the image are box4 convolved with itself, which leaves nothing of a pattern that repeats every
// four pixels. A neighbour counts as far as its depth follows the pixel's own plane: the reciprocal
// of depth is linear in the image on any plane, so a tilted one is smoothed like one that faces the
// camera. The tolerance is a fraction of the depth, so it scales with the units.
// Two pixels of a row at once, which share a texel of what is written: what neighbours both read is
// read once. ACROSS is the first pass: it reads accessibility and depth (DEPTH_BESIDE: which lies beside
// it, as minus its reciprocal, and 1 where empty) and hands both on.
#include "passes/shared_constants.h"

const int kReach = 3;            // taps to each side
const float kTolerance = 0.004;  // of the depth, for each pixel of distance

#ifdef ACROSS
uniform sampler2D t_accessibility;
#ifndef DEPTH_BESIDE
uniform sampler2D t_depth;
#endif
layout(location = 0) out vec4 o_packed;  // accessibility and reciprocal depth, twice
#else
uniform sampler2D t_packed;
layout(location = 0) out vec2 o_accessibility;
#endif

vec2 taps[2 * kReach + 2];  // accessibility and reciprocal depth

// Around taps[i], which lies at `place` of a line that ends at `last`.
float mean_around(int i, int place, int last) {
    float w = taps[i].y;
    // Change of reciprocal depth along the direction: the smaller of the two one-sided differences,
    // so that a silhouette on one side does not count as slope.
    float before = w - taps[i - 1].y;
    float after = taps[i + 1].y - w;
    float slope = abs(before) < abs(after) ? before : after;
    float per_tolerance = 1.0 / (kTolerance * w);
    float sum = 4.0 * taps[i].x;
    float weights = 4.0;
    for (int j = -kReach; j <= kReach; ++j) {
        if (j == 0) continue;
        vec2 tap = taps[i + j];
        float distance_px = abs(float(j));
        float off = (tap.y - (w + slope * float(j))) * (per_tolerance / distance_px);
        float weight = (4.0 - distance_px) * max(0.0, 1.0 - off * off);
        bool counts = weight > 0.0 && place + j >= 0 && place + j <= last;
        sum += counts ? weight * tap.x : 0.0;
        weights += counts ? weight : 0.0;
    }
    // Division need not be exactly rounded: the mean of ones may come out as more than one.
    return w > 1.0 / kBackgroundLimit_m ? min(sum / weights, 1.0) : 1.0;
}

#ifdef ACROSS
vec2 tap_at(ivec2 at) {
#ifdef DEPTH_BESIDE
    vec2 both = texelFetch(t_accessibility, at, 0).rg;
    return vec2(both.r, max(-both.g, 1.0 / kBackgroundDepth_m));
#else
    float depth_m = texelFetch(t_depth, at, 0).r;
    return vec2(texelFetch(t_accessibility, at, 0).r, 1.0 / max(depth_m, 1.0e-9));
#endif
}
#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
#ifdef ACROSS
    int left = 2 * here.x;
    int last = textureSize(t_accessibility, 0).x - 1;
    for (int i = 0; i < 2 * kReach + 2; ++i) {
        taps[i] = tap_at(ivec2(clamp(left + i - kReach, 0, last), here.y));
    }
    o_packed = vec4(mean_around(kReach, left, last), taps[kReach].y,
                    mean_around(kReach + 1, left + 1, last), taps[kReach + 1].y);
#else
    int last = textureSize(t_packed, 0).y - 1;
    vec2 right[2 * kReach + 1];
    for (int i = 0; i < 2 * kReach + 1; ++i) {
        int y = clamp(here.y + i - kReach, 0, last);
        vec4 two = texelFetch(t_packed, ivec2(here.x, y), 0);
        taps[i] = two.rg;
        right[i] = two.ba;
    }
    o_accessibility.x = mean_around(kReach, here.y, last);
    for (int i = 0; i < 2 * kReach + 1; ++i) taps[i] = right[i];
    o_accessibility.y = mean_around(kReach, here.y, last);
#endif
}
