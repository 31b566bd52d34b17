// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/scene/camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "renderer/base/check.h"

namespace obscura::renderer {

CameraMatrices matrices_of(const Camera& camera, int width, int height) {
    const std::string where = "camera " + camera.name;
    base::check_range(where, "vertical_fov_rad", camera.vertical_fov_rad, 1e-3F,
                      std::numbers::pi_v<float> - 1e-3F);
    base::check_range(where, "near_m", camera.near_m, 1e-6F, 1e9F);
    base::check_above(where, "far_m", camera.far_m, camera.near_m, 1e12F);
    base::check_range(where, "lens_shift x", camera.lens_shift.x, -100.0F, 100.0F);
    base::check_range(where, "lens_shift y", camera.lens_shift.y, -100.0F, 100.0F);
    const glm::vec3 forward = camera.target_m - camera.position_m;
    const float across = glm::length(glm::cross(forward, camera.up));
    if (!(glm::length(forward) > 0.0F) || !(across > 0.0F)) {
        throw base::bad_input(
            "{}: position and target must differ, and up must not lie along the "
            "view",
            where);
    }
    CameraMatrices matrices;
    matrices.eye_m = camera.position_m;
    matrices.view_from_world = glm::lookAt(camera.position_m, camera.target_m, camera.up);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    matrices.clip_from_view =
        glm::perspective(camera.vertical_fov_rad, aspect, camera.near_m, camera.far_m);
    const float up_per_metre = std::tan(0.5F * camera.vertical_fov_rad);
    matrices.ray_scale = {up_per_metre * aspect, up_per_metre};
    matrices.ray_offset = camera.lens_shift * matrices.ray_scale;
    matrices.clip_from_view[2][0] = camera.lens_shift.x;
    matrices.clip_from_view[2][1] = camera.lens_shift.y;
    matrices.far_m = camera.far_m;
    return matrices;
}

Camera every_so_many(const Camera& camera, int width, int height, int step) {
    if (step == 1) return camera;
    const auto wider = [step](int size) {
        return static_cast<double>((size + step - 1) / step * step) / size;
    };
    // The first column's middle is the same in both, and columns are `step` times as far apart.
    const auto shift = [step, &wider](float own, int size) {
        const double off = wider(size) - 1.0 - static_cast<double>(step - 1) / size;
        return static_cast<float>((static_cast<double>(own) + off) / wider(size));
    };
    const double up = std::tan(0.5 * static_cast<double>(camera.vertical_fov_rad));
    Camera fewer = camera;
    fewer.vertical_fov_rad = static_cast<float>(2.0 * std::atan(up * wider(height)));
    fewer.lens_shift = {shift(camera.lens_shift.x, width), shift(camera.lens_shift.y, height)};
    return fewer;
}

}  // namespace obscura::renderer
