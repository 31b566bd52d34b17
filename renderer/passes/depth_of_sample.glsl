// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Positive view distance where the middle of a sample meets the surface, metres. Graphics cards snap
// vertices to a grid of 1/256 pixel and interpolate between what was snapped: what comes is a point of
// the surface, but up to that far beside the sample's middle, which on a surface seen at a grazing
// angle is another depth: .08 % where one row is a fifth farther than the last. The change of depth
// over the image takes it back. A rasteriser that does not interpolate so pays no rounding for it.
// To be called before anything is discarded: it takes the neighbours too.
uniform vec2 u_ray_to_px;  // pixels per view x, y per metre of depth
uniform vec2 u_axis_px;    // where the view's axis meets the image, pixels

const float kBeside = 5.0e-7;  // view x, y per metre of depth: a few roundings

float depth_of_sample(vec3 surface) {
    precise float depth_m = -surface.z;
    precise vec2 beside = surface.xy / depth_m - (gl_FragCoord.xy - u_axis_px) / u_ray_to_px;
    precise float over_m = dot(vec2(dFdx(depth_m), dFdy(depth_m)), beside * u_ray_to_px);
    return any(greaterThan(abs(beside), vec2(kBeside))) ? depth_m - over_m : depth_m;
}
