// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Nearly opaque blended surfaces in the buffers that the technique reads (Filion and McNaughton 2008).
#include "passes/normal_codec.glsl"
#include "passes/surface.glsl"

uniform float u_occluding_opacity;
layout(location = 0) out float o_depth_m;
#ifdef NORMAL
layout(location = 1) out vec4 o_normal;
#endif

void main() {
    if (surface_alpha() < u_occluding_opacity) discard;
    o_depth_m = -v_view_position.z;
#ifdef NORMAL
    o_normal = vec4(encode_normal(surface_normal()), u_specular_power / 255.0);
#endif
}
