// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The accessibility at a sample of the image. The technique's is known once a pixel: of the pixel and
// its three neighbours on the sample's side, that whose surface is nearest in depth, its own where
// they differ little. Nothing leaks over the silhouette of what at least one of the four sees; of a
// twig that none does, the nearest surface stands in, and an empty pixel only beside three others.
#include "passes/shared_constants.h"
#ifndef SUPERSAMPLING
#error the number of samples along a pixel's side must be defined
#endif

#include "passes/accessibility_texel.glsl"
#if SUPERSAMPLING > 1
uniform sampler2D t_pixel_depth;    // positive view distance in metres
#endif

float accessibility_of_sample(ivec2 sampled, float depth_m) {
#if SUPERSAMPLING > 1
    ivec2 own = sampled / SUPERSAMPLING;
    ivec2 last = textureSize(t_pixel_depth, 0) - 1;
    ivec2 side = 2 * ((2 * (sampled - own * SUPERSAMPLING) + 1) / SUPERSAMPLING) - 1;
    ivec2 nearest = own;
    float least = 1.0e30;
    for (int i = 0; i < 4; ++i) {
        ivec2 pixel = clamp(own + side * ivec2(i & 1, i >> 1), ivec2(0), last);
        float seen_m = texelFetch(t_pixel_depth, pixel, 0).r;
        if (seen_m >= kBackgroundLimit_m) continue;
        float difference = abs(1.0 / seen_m - 1.0 / depth_m);
        if (i == 0) difference *= 0.5;
        if (difference < least) {
            least = difference;
            nearest = pixel;
        }
    }
    return clamp(accessibility_texel(nearest), 0.0, 1.0);
#else
    return clamp(accessibility_texel(sampled), 0.0, 1.0);
#endif
}
