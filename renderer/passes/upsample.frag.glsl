// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Accessibility of every STEP-th column and row brought up to all pixels (after Kopf et al. 2007, joint
// bilateral upsampling). Of the four texels around a pixel each counts by its distance and as far as its
// depth follows the pixel's own plane, on which the reciprocal of depth is linear in the image; where
// none does, the one whose depth is nearest.
#include "passes/view.glsl"

#include "passes/accessibility_texel.glsl"
uniform sampler2D t_seen_depth;
layout(location = 0) out float o_accessibility;

const float kTolerance = 0.004;  // of the depth, for each pixel of distance, as filters have it

float reciprocal(ivec2 texel) { return 1.0 / max(texelFetch(t_depth, texel, 0).r, 1.0e-9); }

// The change of reciprocal depth to the next pixel: the smaller of the two one-sided differences.
float slope(ivec2 here, float w, ivec2 by) {
    ivec2 last = textureSize(t_depth, 0) - 1;
    float before = w - reciprocal(max(here - by, ivec2(0)));
    float after = reciprocal(min(here + by, last)) - w;
    return abs(before) < abs(after) ? before : after;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    float w = reciprocal(here);
    if (w <= 1.0 / kBackgroundLimit_m) {
        o_accessibility = 1.0;
        return;
    }
    vec2 slopes = vec2(slope(here, w, ivec2(1, 0)), slope(here, w, ivec2(0, 1)));
    ivec2 last = textureSize(t_seen_depth, 0) - 1;
    ivec2 low = here / STEP;
    vec2 part = vec2(here - low * STEP) / float(STEP);
    float sum = 0.0;
    float weights = 0.0;
    float nearest = 1.0e30;
    float otherwise = 1.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 tap = min(low + corner, last);
        vec2 off_px = vec2(tap * STEP - here);
        float open = accessibility_texel(tap);
        float there = 1.0 / max(texelFetch(t_seen_depth, tap, 0).r, 1.0e-9);
        float off = abs(there - (w + dot(slopes, off_px))) / (kTolerance * w);
        float distance_px = abs(off_px.x) + abs(off_px.y);
        off /= max(distance_px, 1.0);
        vec2 share = mix(1.0 - part, part, vec2(corner));
        float weight = share.x * share.y * max(0.0, 1.0 - off * off);
        sum += weight * open;
        weights += weight;
        if (off < nearest) {
            nearest = off;
            otherwise = open;
        }
    }
    o_accessibility = weights > 1.0e-4 ? min(sum / weights, 1.0) : otherwise;
}
