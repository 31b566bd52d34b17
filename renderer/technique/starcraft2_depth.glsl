// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Filion and McNaughton 2008: a smaller depth buffer, of one texel of each square; no mean, which would
// be a surface that is nowhere.
uniform sampler2D t_depth;
layout(location = 0) out float o_depth_m;

void main() {
    ivec2 texel = (ivec2(gl_FragCoord.xy) << DEPTH_SHIFT) + (1 << DEPTH_SHIFT) / 2;
    o_depth_m = texelFetch(t_depth, min(texel, textureSize(t_depth, 0) - 1), 0).r;
}
