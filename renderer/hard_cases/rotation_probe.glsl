// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// How far technique/rotation.glsl and reflection through a unit vector are from what they should
// be, for one vector of a list at each pixel.
#include "technique/rotation.glsl"

uniform sampler2D t_vectors;  // unit vectors
layout(location = 0) out vec4 o_deviation;

void main() {
    vec3 r = texelFetch(t_vectors, ivec2(gl_FragCoord.xy), 0).xyz;
    mat3 m = rotation_to(r);
    mat3 product = transpose(m) * m;
    float from_identity = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            from_identity = max(from_identity, abs(product[i][j] - (i == j ? 1.0 : 0.0)));
        }
    }
    vec3 k = vec3(0.48, -0.6, 0.64);  // of length 1
    float length_change = abs(length(reflect(k, r)) - 1.0);
    vec3 axis = m * vec3(0.0, 0.0, 1.0) - r;
    o_deviation = vec4(from_identity, abs(determinant(m) - 1.0), length(axis), length_change);
    if (any(isnan(o_deviation))) o_deviation = vec4(1.0e9);
}
