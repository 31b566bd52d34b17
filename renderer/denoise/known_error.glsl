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
// SURFACE is the first pass, which writes normals and reciprocal depths once, in place of once for every
// tap; ACROSS is the second, which hands on mean and mean square along a row.
#include "passes/shared_constants.h"

#ifdef SURFACE

#include "passes/normal_codec.glsl"
uniform sampler2D t_depth;
uniform sampler2D t_normal;
layout(location = 0) out vec4 o_surface;  // normal, reciprocal depth

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec3 n = decode_normal(texelFetch(t_normal, here, 0).xyz);
    o_surface = vec4(n, 1.0 / max(texelFetch(t_depth, here, 0).r, 1.0e-9));
}

#else

uniform sampler2D t_surface;
#ifdef ACROSS
uniform sampler2D t_accessibility;
layout(location = 0) out vec4 o_moments;  // mean, mean square, the pixel's own
const ivec2 kDirection = ivec2(1, 0);
#else
uniform sampler2D t_moments;
layout(location = 0) out float o_accessibility;
const ivec2 kDirection = ivec2(0, 1);
#endif

uniform int u_samples;

const int kWide = 7;    // taps to each side: a block of 4x4 twice convolved with 2 of them
const int kNarrow = 3;  // a block convolved with itself
const float kTolerance = 0.004;  // of the depth, for each pixel of distance

// Mean, mean square, the pixel's own value.
vec3 moments_at(ivec2 at) {
#ifdef ACROSS
    float own = texelFetch(t_accessibility, at, 0).r;
    return vec3(own, own * own, own);
#else
    return texelFetch(t_moments, at, 0).xyz;
#endif
}

vec4 surface_at(ivec2 at) { return texelFetch(t_surface, at, 0); }

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(t_surface, 0) - 1;
    vec4 surface = surface_at(here);
    vec3 own = moments_at(here);
    float w = surface.w;
    float before = w - surface_at(max(here - kDirection, ivec2(0))).w;
    float after = surface_at(min(here + kDirection, last)).w - w;
    float slope = abs(before) < abs(after) ? before : after;
    float per_tolerance = 1.0 / (kTolerance * w);
    int reach = u_samples < 4 ? kWide : kNarrow;
    vec2 sum = own.xy * float(reach + 1);
    float weights = float(reach + 1);
    for (int i = -reach; i <= reach; ++i) {
        ivec2 at = here + kDirection * i;
        if (i == 0 || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
        vec4 there = surface_at(at);
        float distance_px = abs(float(i));
        float off = (there.w - (w + slope * float(i))) * (per_tolerance / distance_px);
        float turn = max(dot(there.xyz, surface.xyz), 0.0);
        turn *= turn;
        float weight =
            (float(reach + 1) - distance_px) * max(0.0, 1.0 - off * off) * turn * turn;
        sum += weight * moments_at(at).xy;
        weights += weight;
    }
    // Division need not be exactly rounded: the mean of ones may come out as more than one.
    vec2 mean = w > 1.0 / kBackgroundLimit_m ? min(sum / weights, 1.0) : vec2(1.0);
#ifdef ACROSS
    o_moments = vec4(mean, own.z, 0.0);
#else
    float variance = max(mean.y - mean.x * mean.x, 0.0);
    float count = float(max(u_samples, 1));
    float noise = mean.x * max(1.0 - mean.x, 0.0) / (count * sqrt(count));
    float own_share = max(variance - noise, 0.0) / max(variance, 1.0e-9);
    float caution = min(count / 24.0, 1.0);
    float kept = own_share * (1.0 + caution * (1.0 - own_share));
    o_accessibility = mix(mean.x, own.z, kept);
#endif
}
#endif
