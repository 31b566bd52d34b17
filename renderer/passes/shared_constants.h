// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Read by C++ and by GLSL, so that neither can drift.
#ifndef OBSCURA_SHARED_CONSTANTS
#define OBSCURA_SHARED_CONSTANTS

// Linear depth of a pixel that no triangle covers, and of what lies outside the image: further than
// any scene, and small enough that its square is finite.
const float kBackgroundDepth_m = 1.0e18;
// A depth at or above this is background.
const float kBackgroundLimit_m = 1.0e17;
// Rotations repeat over this many pixels in both directions.
const int kTileSize = 4;

#endif
