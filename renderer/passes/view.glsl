// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The camera, and points of the G-buffer in view space.
#include "passes/shared_constants.h"

uniform vec2 u_size;          // of the image in pixels
uniform vec2 u_ray_scale;     // view x, y per metre of depth at the right and upper border
uniform vec2 u_ray_offset;    // the same at the middle of the image (0 for a centred frustum)
uniform vec2 u_ray_to_px;     // pixels per view x, y per metre of depth
uniform vec2 u_axis_px;       // where the view's axis meets the image, pixels
uniform sampler2D t_depth;    // positive view distance in metres

// The view-space ray of a point of the image, with z = -1.
vec3 view_ray(vec2 uv) { return vec3((uv * 2.0 - 1.0) * u_ray_scale + u_ray_offset, -1.0); }

#if defined(POSITION_STORED) || defined(POSITION_INVERSE)
#define POSITION  // points are not rebuilt by similar triangles
#endif
#ifdef POSITION_STORED
uniform sampler2D t_position;  // view-space points in metres
#endif
#ifdef POSITION_INVERSE
uniform mat4 u_view_from_clip;  // inverse of the projection
#endif

// The view-space point of a surface at a place of the image, in that texel, of depth z: by similar
// triangles; through the inverse of the projection, from the near plane along the ray to the depth;
// or as it is stored (Sunet 2018, 5.4 and 5.5).
vec3 point_at(vec2 uv, ivec2 texel, float z) {
#if defined(POSITION_STORED)
    return texelFetch(t_position, texel, 0).xyz;
#elif defined(POSITION_INVERSE)
    vec4 nearest = u_view_from_clip * vec4(uv * 2.0 - 1.0, -1.0, 1.0);
    return nearest.xyz * (-z / nearest.z);
#else
    return view_ray(uv) * z;
#endif
}

// The ray through that point, with z = -1.
vec3 ray_to(vec2 uv, ivec2 texel, float z) {
#ifdef POSITION
    vec3 point = point_at(uv, texel, z);
    return vec3(point.xy / -point.z, -1.0);
#else
    return view_ray(uv);
#endif
}

// Depth of the texel around a place in pixels; very far outside the image, and where it is not a
// number. Without branches: a fetch that isn't used reads the first texel.
float depth_at_px(vec2 px) {
    bool inside = all(greaterThanEqual(px, vec2(0.0))) && all(lessThan(px, u_size));
    float seen = texelFetch(t_depth, ivec2(inside ? px : vec2(0.0)), 0).r;
    return inside ? seen : kBackgroundDepth_m;
}

// The same of a place from 0 to 1.
float depth_at(vec2 uv) { return depth_at_px(uv * u_size); }

// Where a view-space point falls in the image, in pixels; outside it for a point behind the camera.
vec2 project_to_px(vec3 point) {
    return -point.z > 1.0e-6 ? point.xy * (u_ray_to_px / -point.z) + u_axis_px : vec2(-1.0);
}

// The same from 0 to 1.
vec2 project_to_image(vec3 point) { return project_to_px(point) / u_size; }
