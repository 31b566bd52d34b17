// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Depth as a share of the far plane's, blurred along one direction. ACROSS is the first pass.
#include "passes/shared_constants.h"
#ifdef ACROSS
uniform sampler2D t_depth;
uniform float u_far_m;
const ivec2 kDirection = ivec2(1, 0);
#else
uniform sampler2D t_blurred_across;
const ivec2 kDirection = ivec2(0, 1);
#endif
uniform float p_radius;
layout(location = 0) out float o_depth;

const int kReach = 8;  // taps to each side; the last lies two standard deviations off

float depth_of(ivec2 at) {
#ifdef ACROSS
    return min(texelFetch(t_depth, at, 0).r / u_far_m, 1.0);
#else
    return texelFetch(t_blurred_across, at, 0).r;
#endif
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
#ifdef ACROSS
    ivec2 last = textureSize(t_depth, 0) - 1;
#else
    ivec2 last = textureSize(t_blurred_across, 0) - 1;
#endif
    float step_px = p_radius * float(last.y + 1) / float(kReach);
    float sum = 0.0;
    float weights = 0.0;
    for (int i = -kReach; i <= kReach; ++i) {
        float off = float(i) / float(kReach);
        float weight = exp(-2.0 * off * off);
        ivec2 at = here + kDirection * int(floor(float(i) * step_px + 0.5));
        sum += weight * depth_of(clamp(at, ivec2(0), last));
        weights += weight;
    }
    o_depth = sum / weights;
}
