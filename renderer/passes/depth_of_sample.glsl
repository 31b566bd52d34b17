// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Positive view distance where the middle of a sample meets the surface, metres. Graphics cards snap
// vertices to a grid of 1/256 pixel and interpolate between what was snapped: what comes is a point of
// the surface, but up to that far beside the sample's middle, which on a surface seen at a grazing
// angle is another depth: .08 % where one row is a fifth farther than the last. The reciprocal of depth
// is linear in the image on a triangle, so its change takes that back whole. A rasteriser that does
// not interpolate so pays no rounding for it.
// To be called before anything is discarded: it takes the neighbours too.
uniform vec2 u_ray_to_px;  // pixels per view x, y per metre of depth
uniform vec2 u_axis_px;    // where the view's axis meets the image, pixels

const float kBeside = 5.0e-7;  // view x, y per metre of depth: a few roundings

float depth_of_sample(vec3 surface) {
    precise float depth_m = -surface.z;
    precise float w = 1.0 / depth_m;
    precise vec2 beside = surface.xy * w - (gl_FragCoord.xy - u_axis_px) / u_ray_to_px;
    precise float right = w - dot(vec2(dFdx(w), dFdy(w)), beside * u_ray_to_px);
    bool moved = any(greaterThan(abs(beside), vec2(kBeside))) && right > 0.0;
    return moved ? 1.0 / right : depth_m;
}
