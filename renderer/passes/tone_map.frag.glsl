// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Reinhard et al. 2002, equation 4, applied to luminance so that hues stay.
#include "passes/display.glsl"

uniform sampler2D t_hdr;
uniform float u_exposure;
uniform float u_white;
layout(location = 0) out vec4 o_color;

void main() {
    vec3 color = texelFetch(t_hdr, ivec2(gl_FragCoord.xy), 0).rgb * u_exposure;
    float l = dot(color, vec3(0.2126, 0.7152, 0.0722));
    float mapped = (1.0 + l / (u_white * u_white)) / (1.0 + l);
    o_color = vec4(encode_srgb(color * mapped), 1.0);
}
