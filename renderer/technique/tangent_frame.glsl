// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The frame whose third axis is the unit vector n, turned about it by the unit vector r after Gram and
// Schmidt; where the two are so close that nothing is left of r, a frame about n alone.
#include "technique/rotation.glsl"

mat3 tangent_frame(vec3 n, vec3 r) {
    vec3 t = r - n * dot(r, n);
    float squared = dot(t, t);
    if (squared < 4.0e-3) return rotation_to(n);
    t *= inversesqrt(squared);
    return mat3(t, cross(n, t), n);
}
