// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What the frame before made, for the next one; 1 before the first.
layout(location = 0) out float o_accessibility;
#ifndef FIRST
uniform sampler2D t_accessibility;
#endif

void main() {
#ifdef FIRST
    o_accessibility = 1.0;
#else
    o_accessibility = texelFetch(t_accessibility, ivec2(gl_FragCoord.xy), 0).r;
#endif
}
