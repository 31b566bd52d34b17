// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The rotation that takes +Z to the unit vector r; orthonormal for every r, -Z included
// (Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3).
mat3 rotation_to(vec3 r) {
    float s = r.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + r.z);
    float b = r.x * r.y * a;
    return mat3(vec3(1.0 + s * r.x * r.x * a, s * b, -s * r.x), vec3(b, s + r.y * r.y * a, -r.y),
                r);
}
