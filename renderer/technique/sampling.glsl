// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What sampled techniques share: the tile of random unit vectors.
uniform sampler2D t_rotations;  // NOISE_SIZE x NOISE_SIZE unit vectors

vec3 random_vector() { return texelFetch(t_rotations, ivec2(gl_FragCoord.xy) % NOISE_SIZE, 0).xyz; }
