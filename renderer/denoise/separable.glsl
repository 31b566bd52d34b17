// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A bilateral filter in two passes (after Bavoil and Sainz 2009, which the thesis used). The weights
// in the image are box4 convolved with itself, which leaves nothing of a pattern that repeats every
// four pixels. A neighbour counts as far as its depth follows the pixel's own plane: the reciprocal
// of depth is linear in the image on any plane, so a tilted one is smoothed like one that faces the
// camera. The tolerance is a fraction of the depth, so it scales with the units.
#include "passes/shared_constants.h"
#ifndef DIRECTION
#error the direction must be defined: ivec2(1, 0) or ivec2(0, 1)
#endif

uniform sampler2D t_accessibility;
uniform sampler2D t_depth;
layout(location = 0) out float o_accessibility;

const float kTolerance = 0.004;  // of the depth, for each pixel of distance

ivec2 g_last;

float reciprocal_depth(ivec2 at) {
    return 1.0 / max(texelFetch(t_depth, clamp(at, ivec2(0), g_last), 0).r, 1.0e-9);
}

// Change of reciprocal depth along the direction: the smaller of the two one-sided differences, so
// that a silhouette on one side does not count as slope.
float slope_at(ivec2 here, ivec2 direction, float w) {
    float before = w - reciprocal_depth(here - direction);
    float after = reciprocal_depth(here + direction) - w;
    return abs(before) < abs(after) ? before : after;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 direction = DIRECTION;
    g_last = textureSize(t_depth, 0) - 1;
    float w = reciprocal_depth(here);
    float slope = slope_at(here, direction, w);
    float sum = 4.0 * texelFetch(t_accessibility, here, 0).r;
    float weights = 4.0;
    for (int i = -3; i <= 3; ++i) {
        ivec2 at = here + direction * i;
        if (i == 0 || at != clamp(at, ivec2(0), g_last)) continue;
        float distance_px = abs(float(i));
        float off = (reciprocal_depth(at) - (w + slope * float(i))) / (kTolerance * w * distance_px);
        float weight = (4.0 - distance_px) * max(0.0, 1.0 - off * off);
        if (!(weight > 0.0)) continue;
        sum += weight * texelFetch(t_accessibility, at, 0).r;
        weights += weight;
    }
    o_accessibility = sum / weights;
}
