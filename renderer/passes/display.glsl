// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Linear Rec. 709 to sRGB code values (IEC 61966-2-1), rounded to 8 bits by the target.
vec3 encode_srgb(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(1.0e-6)), vec3(1.0 / 2.4)) - 0.055,
               step(vec3(0.0031308), c));
}

vec3 decode_srgb(vec3 code) {
    return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), code));
}
