// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// From scene light to display light, by one curve.
#include "passes/display.glsl"

uniform sampler2D t_hdr;
uniform float u_exposure;
uniform float u_white;
layout(location = 0) out vec4 o_color;

#if defined(CURVE_REINHARD)
// Reinhard et al. 2002, equation 4, applied to luminance so that hues stay.
vec3 curve(vec3 color) {
    float l = dot(color, vec3(0.2126, 0.7152, 0.0722));
    return color * ((1.0 + l / (u_white * u_white)) / (1.0 + l));
}
#elif defined(CURVE_FILMIC)
// Hable 2010, "Uncharted 2: HDR Lighting", with his constants.
vec3 hable(vec3 x) {
    return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3;
}
vec3 curve(vec3 color) { return hable(max(color, vec3(0.0))) / hable(vec3(u_white)); }
#elif defined(CURVE_ACES)
// Narkowicz 2016, "ACES Filmic Tone Mapping Curve".
vec3 curve(vec3 color) {
    vec3 x = max(color, vec3(0.0));
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}
#elif defined(CURVE_CLIP)
vec3 curve(vec3 color) { return color; }
#else
#error the tone curve must be defined
#endif

void main() {
    vec3 color = texelFetch(t_hdr, ivec2(gl_FragCoord.xy), 0).rgb * u_exposure;
    o_color = vec4(encode_srgb(curve(color)), 1.0);
}
