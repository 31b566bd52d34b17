// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A filter that knows how far samples may be off (after Lee 1980, "Digital Image Enhancement and Noise
// Filtering by Use of Local Statistics"). Of the neighbours on the pixel's own surface it takes mean and
// variance. One yes-or-no sample of the mean m has a variance of m (1 - m), and N that keep their distance
// of N^-1.5 times that (Owen 1997, for jumps in two dimensions); what the neighbours vary more than that
// is the image's own, and the pixel keeps that share of its own value, the more cautiously the more
// samples there are: the share itself, which is Lee's, blurs the edges of occlusion by more than it then
// takes of the noise. So the more samples there are, the less is smoothed; from four on, a narrower
// surrounding is enough. Samples that repeat over a tile have no error of chance: u_samples is 0, and all
// of it is smoothed. A neighbour is on the surface as far as its depth follows the pixel's own plane, on
// which the reciprocal of depth is linear in the image, and its normal the pixel's normal.
// ACROSS is the first pass, which hands on mean and mean square along a row.
#include "passes/normal_codec.glsl"
#include "passes/shared_constants.h"

uniform sampler2D t_normal;
#ifdef ACROSS
uniform sampler2D t_accessibility;
uniform sampler2D t_depth;
layout(location = 0) out vec4 o_packed;  // mean, mean square, reciprocal depth, the pixel's own
const ivec2 kDirection = ivec2(1, 0);
#else
uniform sampler2D t_packed;
layout(location = 0) out float o_accessibility;
const ivec2 kDirection = ivec2(0, 1);
#endif

uniform int u_samples;

const int kWide = 7;    // taps to each side: a block of 4x4 twice convolved with 2 of them
const int kNarrow = 3;  // a block convolved with itself
const float kTolerance = 0.004;  // of the depth, for each pixel of distance

// Mean, mean square, reciprocal depth, the pixel's own value.
vec4 tap_at(ivec2 at) {
#ifdef ACROSS
    float own = texelFetch(t_accessibility, at, 0).r;
    return vec4(own, own * own, 1.0 / max(texelFetch(t_depth, at, 0).r, 1.0e-9), own);
#else
    return texelFetch(t_packed, at, 0);
#endif
}

vec3 normal_at(ivec2 at) { return decode_normal(texelFetch(t_normal, at, 0).xyz); }

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(t_normal, 0) - 1;
    vec3 n = normal_at(here);
    vec4 own = tap_at(here);
    float w = own.z;
    float before = w - tap_at(max(here - kDirection, ivec2(0))).z;
    float after = tap_at(min(here + kDirection, last)).z - w;
    float slope = abs(before) < abs(after) ? before : after;
    float per_tolerance = 1.0 / (kTolerance * w);
    int reach = u_samples < 4 ? kWide : kNarrow;
    vec2 sum = own.xy * float(reach + 1);
    float weights = float(reach + 1);
    for (int i = -reach; i <= reach; ++i) {
        ivec2 at = here + kDirection * i;
        if (i == 0 || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
        vec4 tap = tap_at(at);
        float distance_px = abs(float(i));
        float off = (tap.z - (w + slope * float(i))) * (per_tolerance / distance_px);
        float turn = max(dot(normal_at(at), n), 0.0);
        turn *= turn;
        float weight =
            (float(reach + 1) - distance_px) * max(0.0, 1.0 - off * off) * turn * turn;
        sum += weight * tap.xy;
        weights += weight;
    }
    // Division need not be exactly rounded: the mean of ones may come out as more than one.
    vec2 mean = w > 1.0 / kBackgroundLimit_m ? min(sum / weights, 1.0) : vec2(1.0);
#ifdef ACROSS
    o_packed = vec4(mean, w, own.w);
#else
    float variance = max(mean.y - mean.x * mean.x, 0.0);
    float count = float(max(u_samples, 1));
    float noise = mean.x * max(1.0 - mean.x, 0.0) / (count * sqrt(count));
    float own_share = max(variance - noise, 0.0) / max(variance, 1.0e-9);
    float caution = min(count / 24.0, 1.0);
    float kept = own_share * (1.0 + caution * (1.0 - own_share));
    o_accessibility = mix(mean.x, own.w, kept);
#endif
}
