// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The camera, and points of the G-buffer in view space.
#include "passes/shared_constants.h"

uniform vec2 u_size;          // of the image in pixels
uniform mat4 u_projection;    // clip from view
uniform vec2 u_ray_scale;     // view x, y per metre of depth at the right and upper border
uniform vec2 u_ray_offset;    // the same at the middle of the image (0 for a centred frustum)
uniform sampler2D t_depth;    // positive view distance in metres

// The view-space ray of a point of the image, with z = -1.
vec3 view_ray(vec2 uv) { return vec3((uv * 2.0 - 1.0) * u_ray_scale + u_ray_offset, -1.0); }

// Depth of the nearest texel; very far outside the image, and where uv is not a number.
float depth_at(vec2 uv) {
    if (!(all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0))))) {
        return kBackgroundDepth_m;
    }
    return texelFetch(t_depth, ivec2(uv * u_size), 0).r;
}

// Where a view-space point falls in the image; outside it for a point behind the camera.
vec2 project_to_image(vec3 point) {
    vec4 clip = u_projection * vec4(point, 1.0);
    if (!(clip.w > 1.0e-6)) return vec2(-1.0);
    return clip.xy / clip.w * 0.5 + 0.5;
}
