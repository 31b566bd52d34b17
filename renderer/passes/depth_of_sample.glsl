// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Positive view distance where the middle of a sample meets the surface, metres. Graphics cards snap
// vertices to a grid of 1/256 pixel and interpolate between what was snapped: what comes is a point of
// the surface, but up to that far beside the sample's middle, which on a surface seen at a grazing
// angle is another depth: .08 % where one row is a fifth farther than the last. The change of depth
// over the image takes it back. A rasteriser that does not interpolate so pays no rounding for it.
uniform vec2 u_ray_to_px;  // pixels per view x, y per metre of depth
uniform vec2 u_axis_px;    // where the view's axis meets the image, pixels

const float kBeside_px = 1.0 / 4096.0;

float depth_of_sample(vec3 surface) {
    precise float depth_m = -surface.z;
    precise vec2 off_px = surface.xy * (u_ray_to_px / depth_m) + u_axis_px - gl_FragCoord.xy;
    precise float over_m = dot(vec2(dFdx(depth_m), dFdy(depth_m)), off_px);
    bool beside = any(greaterThan(abs(off_px), vec2(kBeside_px)));
    return beside ? depth_m - over_m : depth_m;
}
