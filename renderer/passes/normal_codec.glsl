// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Unit vectors as a buffer stores them. Without a define 8 bits a component: -1, 0 and 1 are exact.
// NORMAL_RG8: the same without z, which is rebuilt towards the camera. NORMAL_OCT16: folded onto an
// octahedron (Cigolle et al. 2014), 16 bits a component.
#ifdef NORMAL_OCT16
vec3 encode_normal(vec3 n) {
    vec2 e = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) {
        e = (1.0 - abs(e.yx)) * vec2(e.x >= 0.0 ? 1.0 : -1.0, e.y >= 0.0 ? 1.0 : -1.0);
    }
    return vec3(e * 0.5 + 0.5, 0.0);
}

vec3 decode_normal(vec3 code) {
    vec2 e = code.xy * 2.0 - 1.0;
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    float fold = max(-n.z, 0.0);
    n.x += n.x >= 0.0 ? -fold : fold;
    n.y += n.y >= 0.0 ? -fold : fold;
    return n * inversesqrt(dot(n, n));
}
#else
vec3 encode_normal(vec3 n) { return (n * 127.0 + 128.0) / 255.0; }

vec3 decode_normal(vec3 code) {
    vec3 n = (code * 255.0 - 128.0) / 127.0;
#ifdef NORMAL_RG8
    n.z = sqrt(max(1.0 - dot(n.xy, n.xy), 0.0));
#endif
    float squared = dot(n, n);
    return squared > 1.0e-12 ? n * inversesqrt(squared) : vec3(0.0, 0.0, 1.0);
}
#endif
