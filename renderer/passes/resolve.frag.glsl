// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The samples of a pixel, averaged in linear light.
#include "passes/display.glsl"
#ifndef SUPERSAMPLING
#error the number of samples along a pixel's side must be defined
#endif

uniform sampler2D t_display;
layout(location = 0) out vec4 o_color;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * SUPERSAMPLING;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < SUPERSAMPLING; ++y) {
        for (int x = 0; x < SUPERSAMPLING; ++x) {
            sum += decode_srgb(texelFetch(t_display, first + ivec2(x, y), 0).rgb);
        }
    }
    o_color = vec4(encode_srgb(sum / float(SUPERSAMPLING * SUPERSAMPLING)), 1.0);
}
