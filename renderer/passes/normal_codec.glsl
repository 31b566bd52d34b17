// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Unit vectors in 8 bits a component: -1, 0 and 1 are exact.
vec3 encode_normal(vec3 n) { return (n * 127.0 + 128.0) / 255.0; }

vec3 decode_normal(vec3 code) {
    vec3 n = (code * 255.0 - 128.0) / 127.0;
    float squared = dot(n, n);
    return squared > 1.0e-12 ? n * inversesqrt(squared) : vec3(0.0, 0.0, 1.0);
}
