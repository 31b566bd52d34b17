// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The accessibility of a pixel out of a buffer that holds ACCESSIBILITY_COLUMNS pixels of a row in a
// texel.
#ifndef ACCESSIBILITY_COLUMNS
#error the number of columns in a texel must be defined
#endif

uniform sampler2D t_accessibility;

float accessibility_texel(ivec2 at) {
#if ACCESSIBILITY_COLUMNS == 2
    vec2 two = texelFetch(t_accessibility, ivec2(at.x >> 1, at.y), 0).rg;
    return (at.x & 1) == 0 ? two.r : two.g;
#else
    return texelFetch(t_accessibility, at, 0).r;
#endif
}
