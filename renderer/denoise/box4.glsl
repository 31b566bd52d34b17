// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The mean over the tile of rotations around a pixel (Whinham 2017). It knows no edges.
#include "passes/shared_constants.h"

uniform sampler2D t_accessibility;
layout(location = 0) out float o_accessibility;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(t_accessibility, 0) - 1;
    float sum = 0.0;
    for (int y = 0; y < kTileSize; ++y) {
        for (int x = 0; x < kTileSize; ++x) {
            ivec2 at = here + ivec2(x, y) - kTileSize / 2;
            sum += texelFetch(t_accessibility, clamp(at, ivec2(0), last), 0).r;
        }
    }
    o_accessibility = sum / float(kTileSize * kTileSize);
}
