// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/flight.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/import/import.h"
#include "stimuli/study.h"

namespace obscura::app::explorer {
namespace {

constexpr float kMostPitch_rad = glm::radians(89.0F);
constexpr float kLeastFov_deg = 1.0F;
constexpr float kMostFov_deg = 170.0F;
constexpr float kFarthest_m = renderer::ImportLimits::kFarthest_m;
constexpr glm::vec3 kUp{0.0F, 1.0F, 0.0F};

[[nodiscard]] bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Where a camera looks, as angles: about Y from -Z to +X, and above the horizon.
struct Heading {
    float right_rad = 0.0F;
    float up_rad = 0.0F;
    float distance_m = 1.0F;  ///< to the target

    [[nodiscard]] glm::vec3 direction() const {
        return {std::cos(up_rad) * std::sin(right_rad), std::sin(up_rad),
                -std::cos(up_rad) * std::cos(right_rad)};
    }
};

[[nodiscard]] Heading heading_of(const renderer::Camera& camera) {
    const glm::vec3 ahead = camera.target_m - camera.position_m;
    Heading heading;
    const float length = glm::length(ahead);
    if (!(length > 0.0F) || !std::isfinite(length)) return heading;
    heading.distance_m = length;
    const glm::vec3 unit = ahead / length;
    heading.up_rad =
        std::clamp(std::asin(std::clamp(unit.y, -1.0F, 1.0F)), -kMostPitch_rad, kMostPitch_rad);
    // Straight up or down the camera's own up says which way it faces.
    const bool steep = std::hypot(unit.x, unit.z) < 1e-4F;
    const glm::vec3 level = steep ? (unit.y > 0.0F ? -camera.up : camera.up) : unit;
    heading.right_rad = std::atan2(level.x, -level.z);
    return heading;
}

/// Where single precision would lose the distance between camera and target, further ahead.
[[nodiscard]] glm::vec3 target_of(const glm::vec3& position_m, const Heading& heading) {
    const float size =
        std::max({std::abs(position_m.x), std::abs(position_m.y), std::abs(position_m.z), 1e-3F});
    const float distance_m = std::max(heading.distance_m, 1e-3F * size);
    return position_m + distance_m * heading.direction();
}

[[nodiscard]] renderer::Camera placed(const renderer::Camera& like, const glm::vec3& position_m,
                                      const Heading& heading) {
    renderer::Camera camera = like;
    camera.name = stimuli::kStudyCamera;
    // Within what a study file may say, and with room for the target, so that the two never meet.
    camera.position_m = glm::clamp(position_m, -0.9F * kFarthest_m, 0.9F * kFarthest_m);
    Heading near = heading;
    near.distance_m = std::min(heading.distance_m, 0.1F * kFarthest_m);
    camera.target_m = target_of(camera.position_m, near);
    camera.up = kUp;
    camera.lens_shift = glm::vec2(0.0F);
    return camera;
}

[[nodiscard]] glm::vec3 right_of(const Heading& heading) {
    return {std::cos(heading.right_rad), 0.0F, std::sin(heading.right_rad)};
}

}  // namespace

renderer::Camera upright(const renderer::Camera& camera) {
    const float degrees = glm::degrees(camera.vertical_fov_rad);
    return with_fov(placed(camera, camera.position_m, heading_of(camera)), degrees);
}

renderer::Camera flown(const renderer::Camera& camera, const glm::vec3& by_m) {
    const renderer::Camera from = upright(camera);
    if (!finite(by_m)) return from;
    const Heading heading = heading_of(from);
    const glm::vec3 ahead = heading.direction();
    const glm::vec3 right = right_of(heading);
    const glm::vec3 up = glm::cross(right, ahead);
    return placed(from, from.position_m + by_m.x * right + by_m.y * up + by_m.z * ahead, heading);
}

renderer::Camera turned(const renderer::Camera& camera, float right_rad, float up_rad) {
    const renderer::Camera from = upright(camera);
    if (!std::isfinite(right_rad) || !std::isfinite(up_rad)) return from;
    Heading heading = heading_of(from);
    heading.right_rad = std::remainder(heading.right_rad + right_rad, glm::two_pi<float>());
    heading.up_rad = std::clamp(heading.up_rad + up_rad, -kMostPitch_rad, kMostPitch_rad);
    return placed(from, from.position_m, heading);
}

renderer::Camera orbited(const renderer::Camera& camera, const glm::vec3& about_m, float right_rad,
                         float up_rad) {
    const renderer::Camera from = upright(camera);
    if (!finite(about_m) || !std::isfinite(right_rad) || !std::isfinite(up_rad)) return from;
    const Heading before = heading_of(from);
    const renderer::Camera after_turn = turned(from, right_rad, up_rad);
    const Heading after = heading_of(after_turn);
    // The point keeps its place in the camera's own axes, so it keeps its place in the image.
    const glm::vec3 to_point = about_m - from.position_m;
    const auto axes = [](const Heading& heading) {
        const glm::vec3 right = right_of(heading);
        const glm::vec3 ahead = heading.direction();
        return glm::mat3(right, glm::cross(right, ahead), ahead);
    };
    const glm::vec3 seen = glm::transpose(axes(before)) * to_point;
    return placed(from, about_m - axes(after) * seen, after);
}

renderer::Camera with_fov(const renderer::Camera& camera, float degrees) {
    renderer::Camera changed = camera;
    if (!std::isfinite(degrees)) return changed;
    changed.name = stimuli::kStudyCamera;
    changed.vertical_fov_rad = glm::radians(std::clamp(degrees, kLeastFov_deg, kMostFov_deg));
    return changed;
}

renderer::Camera framing(const renderer::Camera& camera, const renderer::Bounds& bounds,
                         float aspect) {
    const renderer::Camera from = upright(camera);
    const glm::vec3 middle = 0.5F * (bounds.low_m + bounds.high_m);
    const float radius = std::max(0.5F * glm::length(bounds.high_m - bounds.low_m), 1e-3F);
    if (!finite(middle) || !std::isfinite(radius)) return from;
    const float half_height = 0.5F * from.vertical_fov_rad;
    const float half_width = std::atan(std::tan(half_height) * std::max(aspect, 1e-3F));
    const float distance = radius / std::sin(std::min(half_height, half_width));
    Heading heading = heading_of(from);
    heading.distance_m = distance;
    renderer::Camera camera_out = placed(from, middle - distance * heading.direction(), heading);
    camera_out.far_m = std::min(std::max(camera_out.far_m, 2.0F * (distance + radius)), 1e7F);
    return camera_out;
}

glm::vec3 point_at(const renderer::Camera& camera, float aspect, const glm::vec2& at,
                   float depth_m) {
    const Heading heading = heading_of(camera);
    const glm::vec3 right = right_of(heading);
    const glm::vec3 ahead = heading.direction();
    const float height = std::tan(0.5F * camera.vertical_fov_rad);
    const glm::vec2 side = (2.0F * at - 1.0F) * glm::vec2(height * aspect, -height);
    return camera.position_m +
           depth_m * (ahead + side.x * right + side.y * glm::cross(right, ahead));
}

bool same_view(const renderer::Camera& a, const renderer::Camera& b) {
    return a.position_m == b.position_m && a.target_m == b.target_m && a.up == b.up &&
           a.vertical_fov_rad == b.vertical_fov_rad && a.near_m == b.near_m && a.far_m == b.far_m &&
           a.lens_shift == b.lens_shift;
}

float usual_speed_m_s(const renderer::Bounds& bounds) {
    const float size = glm::length(bounds.high_m - bounds.low_m);
    return std::isfinite(size) && size > 0.0F ? size / 10.0F : 1.0F;
}

}  // namespace obscura::app::explorer
