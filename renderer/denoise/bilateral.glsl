// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The bilateral filter over its full window (Tomasi and Manduchi 1998, as in Sunet 2018, 4.3.4). The
// weights in the image are box4 convolved with itself in both directions, which leaves nothing of a
// pattern that repeats every four pixels; a neighbour counts as far as its depth follows the pixel's
// own plane, on which the reciprocal of depth is linear in the image.
#include "passes/shared_constants.h"

uniform sampler2D t_accessibility;
uniform sampler2D t_depth;
layout(location = 0) out float o_accessibility;

const int kReach = 3;            // taps to each side
const float kTolerance = 0.004;  // of the depth, for each pixel of distance

float reciprocal_depth(ivec2 at, ivec2 last) {
    return 1.0 / max(texelFetch(t_depth, clamp(at, ivec2(0), last), 0).r, 1.0e-9);
}

// The smaller change of two, so that a silhouette on one side does not count as slope.
float slope_of(float before, float here, float after) {
    return abs(here - before) < abs(after - here) ? here - before : after - here;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(t_depth, 0) - 1;
    float w = reciprocal_depth(here, last);
    float across = slope_of(reciprocal_depth(here - ivec2(1, 0), last), w,
                            reciprocal_depth(here + ivec2(1, 0), last));
    float up = slope_of(reciprocal_depth(here - ivec2(0, 1), last), w,
                        reciprocal_depth(here + ivec2(0, 1), last));
    float per_tolerance = 1.0 / (kTolerance * w);
    float sum = 16.0 * texelFetch(t_accessibility, here, 0).r;
    float weights = 16.0;
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 at = here + ivec2(x, y);
            if ((x == 0 && y == 0) || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) {
                continue;
            }
            float plane = w + across * float(x) + up * float(y);
            float off = (reciprocal_depth(at, last) - plane) *
                        (per_tolerance / float(max(abs(x), abs(y))));
            float weight = (4.0 - abs(float(x))) * (4.0 - abs(float(y))) * (1.0 - off * off);
            bool counts = weight > 0.0;
            sum += counts ? weight * texelFetch(t_accessibility, at, 0).r : 0.0;
            weights += counts ? weight : 0.0;
        }
    }
    // Division need not be exactly rounded: the mean of ones may come out as more than one.
    o_accessibility = w > 1.0 / kBackgroundLimit_m ? min(sum / weights, 1.0) : 1.0;
}
