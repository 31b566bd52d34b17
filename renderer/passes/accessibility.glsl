// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Included at the end of a technique's file, which defines `float accessibility(vec2 uv, float z)`.
// Runs on every pixel that a triangle covers; the target is cleared to 1 before, so that empty pixels
// are exactly 1.
#ifndef SAMPLES
#error the number of samples must be defined
#endif

#ifdef DEPTH_BESIDE
layout(location = 0) out vec2 o_accessibility;  // minus the reciprocal of depth beside it
#else
layout(location = 0) out float o_accessibility;
#endif

#ifdef FRAMES_BEFORE
uniform sampler2D t_history;  // the mean of the frames before
#endif

void main() {
    vec2 uv = gl_FragCoord.xy / u_size;
    float z = texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r;
    float open = z >= kBackgroundLimit_m ? 1.0 : accessibility(uv, z);
#ifdef FRAMES_BEFORE
    float before = texelFetch(t_history, ivec2(gl_FragCoord.xy), 0).r;
    open = before + (open - before) * (1.0 / (FRAMES_BEFORE + 1.0));
#endif
#ifdef DEPTH_BESIDE
    o_accessibility = vec2(open, -1.0 / max(z, 1.0e-9));
#else
    o_accessibility = open;
#endif
}
