// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/pixel_tracer.h"

#include <xmmintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/passes/shared_constants.h"
#include "renderer/scene/camera.h"

namespace obscura::renderer {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A right-handed orthonormal frame whose third axis is n (Duff et al. 2017, equation 6 with the
/// sign of n.z, which keeps it exact near -Z).
glm::mat3 frame_about(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double s = -1.0 / (sign + n.z);
    const double t = n.x * n.y * s;
    return {glm::vec3(1.0 + sign * n.x * n.x * s, sign * t, -sign * n.x),
            glm::vec3(t, sign + n.y * n.y * s, -n.y), glm::vec3(n)};
}

/// The first thing a ray meets.
RTCRayHit first_hit(const RayScene& scene, const PixelRays& pixels, const glm::dvec3& direction) {
    RTCRayHit hit{ray_from(glm::vec3(pixels.position_m()), glm::vec3(direction),
                           static_cast<float>(pixels.near_m()), static_cast<float>(pixels.far_m())),
                  {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RayScene::Context context(true);
    rtcIntersect1(scene.embree(), &context, &hit);
    return hit;
}

/// The normal between those of the vertices, on the side of the face that the camera sees: turned
/// over on the back of a surface, as the rasteriser's, and where it points to the face's other side
/// (FaceForward of Pharr, Jakob and Humphreys 2023, section 3.5), which no surface has. `face` is
/// the triangle's own, towards the camera, which stands in where there is none.
glm::dvec3 shading_normal(const RayScene::Triangle& triangle, const RTCHit& hit,
                          const glm::dvec3& face) {
    const glm::dvec3 sum = (1.0 - hit.u - hit.v) * glm::dvec3(triangle.normal[0]) +
                           static_cast<double>(hit.u) * glm::dvec3(triangle.normal[1]) +
                           static_cast<double>(hit.v) * glm::dvec3(triangle.normal[2]);
    const double length = glm::length(sum);
    if (!(length > 1e-10) || !std::isfinite(length)) return face;
    return sum * ((glm::dot(sum, face) < 0.0 ? -1.0 : 1.0) / length);
}

/// The start of rays and the corners of triangles are floats, and Embree computes with their
/// differences in floats. What that can shift a surface by grows with the point's coordinates and
/// the triangle's size; the offset (after Waechter and Binder 2019, "A fast and robust method for
/// avoiding self-intersection", but scaled by this bound in place of their constants, which assume
/// scenes of about a metre) is 16 units of last place of it, a hundred-thousandth of R at most in
/// any scene that floats can hold well.
double offset_for(const RayScene::Triangle& triangle, const glm::dvec3& point) {
    double scale = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    double extent = 0.0;
    for (const glm::dvec3& corner : triangle.corner) {
        extent = std::max(extent, glm::length(corner - point));
    }
    return 16.0 * 0x1.0p-24 * (scale + extent);
}

}  // namespace

PixelRays::PixelRays(const Camera& camera, int width, int height, const glm::dvec3& scene_origin_m)
    : pixels_(width, height), near_m_(camera.near_m), far_m_(camera.far_m) {
    const CameraMatrices matrices = matrices_of(camera, width, height);
    position_m_ = glm::dvec3(camera.position_m) - scene_origin_m;
    forward_ = glm::normalize(glm::dvec3(camera.target_m) - glm::dvec3(camera.position_m));
    const glm::dvec3 right = glm::normalize(glm::cross(forward_, glm::dvec3(camera.up)));
    right_ = right * static_cast<double>(matrices.ray_scale.x);
    up_ = glm::cross(right, forward_) * static_cast<double>(matrices.ray_scale.y);
    offset_ = glm::dvec2(matrices.ray_offset) / glm::dvec2(matrices.ray_scale);
}

glm::dvec3 PixelRays::direction(int x, int y) const {
    const double across = 2.0 * (x + 0.5) / pixels_.x - 1.0;
    const double above = 1.0 - 2.0 * (y + 0.5) / pixels_.y;
    return forward_ + (across + offset_.x) * right_ + (above + offset_.y) * up_;
}

PixelTracer::PixelTracer(const RayScene& scene, const PixelRays& pixels,
                         const ReferenceOptions& options, const HemisphereSampler& sampler)
    : scene_(scene),
      pixels_(pixels),
      options_(options),
      sampler_(sampler),
      saved_float_mode_(_mm_getcsr()) {
    // Whole packets, so that none needs a remainder of its own.
    const auto room = static_cast<std::size_t>((sampler.rays() + kPacket - 1) / kPacket * kPacket);
    for (std::vector<float>* values : {&x_, &y_, &z_, &occlusion_}) values->resize(room);
    _mm_setcsr(saved_float_mode_ | kFlushDenormals);
}

PixelTracer::~PixelTracer() { _mm_setcsr(saved_float_mode_); }

bool PixelTracer::find_surface(int x, int y, Surface& surface) const {
    const glm::dvec3 direction = pixels_.direction(x, y);
    const RTCRayHit found = first_hit(scene_, pixels_, direction);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const RayScene::Triangle triangle = scene_.triangle(found.hit.geomID, found.hit.primID);
    glm::dvec3 normal = glm::normalize(glm::cross(triangle.corner[1] - triangle.corner[0],
                                                  triangle.corner[2] - triangle.corner[0]));
    if (glm::dot(normal, direction) > 0.0) normal = -normal;
    const glm::dvec3 shading = shading_normal(triangle, found.hit, normal);
    // Where the ray meets the triangle's plane, in double precision; seen edge-on that has no
    // answer, and Embree's stands.
    surface.depth_m = found.ray.tfar;
    const double plane_m =
        glm::dot(normal, triangle.corner[0] - pixels_.position_m()) / glm::dot(normal, direction);
    if (std::abs(plane_m - surface.depth_m) < 1e-3 * surface.depth_m) surface.depth_m = plane_m;
    const glm::dvec3 point = pixels_.position_m() + surface.depth_m * direction;
    surface.start_m = glm::vec3(point + offset_for(triangle, point) * normal);
    surface.geometric_normal = glm::vec3(normal);
    surface.normal = options_.normal == NormalKind::kShading ? shading : normal;
    return true;
}

void PixelTracer::cast_occlusion(const Surface& surface) {
    RayScene::Context context(false);
    // Sixteen neighbours of the sampler's list. Of single rays, packets of 4, 8 and 16 and streams,
    // each with and without this flag, the quickest on two of the built-in scenes of three.
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const auto far = static_cast<float>(options_.radius_m);
    const int rays = sampler_.rays();
    alignas(64) int valid[kPacket];
    RTCRay16 packet{};
    for (int first = 0; first < rays; first += kPacket) {
        for (int i = 0; i < kPacket; ++i) {
            const auto k = static_cast<std::size_t>(first + i);
            valid[i] = first + i < rays ? -1 : 0;
            packet.org_x[i] = surface.start_m.x;
            packet.org_y[i] = surface.start_m.y;
            packet.org_z[i] = surface.start_m.z;
            packet.dir_x[i] = x_[k];
            packet.dir_y[i] = y_[k];
            packet.dir_z[i] = z_[k];
            packet.tnear[i] = 0.0F;
            packet.tfar[i] = far;
            packet.mask[i] = ~0U;
        }
        rtcOccluded16(valid, scene_.embree(), &context, &packet);
        for (int i = 0; i < kPacket; ++i) {
            occlusion_[static_cast<std::size_t>(first + i)] = packet.tfar[i] < 0.0F ? 1.0F : 0.0F;
        }
    }
}

void PixelTracer::cast_falloff(const Surface& surface) {
    RayScene::Context context(false);
    const auto far = static_cast<float>(options_.radius_m);
    for (std::size_t k = 0; k < static_cast<std::size_t>(sampler_.rays()); ++k) {
        RTCRayHit ray{ray_from(glm::vec3(surface.start_m), {x_[k], y_[k], z_[k]}, 0.0F, far), {}};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_.embree(), &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
            occlusion_[k] = 0.0F;
            continue;
        }
        const float t = std::min(ray.ray.tfar / far, 1.0F);
        occlusion_[k] = options_.falloff == Falloff::kLinear ? 1.0F - t : 1.0F - t * t;
    }
}

TracedPixel PixelTracer::gathered(const Surface& surface) const {
    const int rays = sampler_.rays();
    const int parts = sampler_.parts();
    std::array<double, 256> of_part{};  // a part's number is a byte
    const std::vector<std::uint8_t>& part_of_ray = sampler_.part_of_ray();
    for (std::size_t k = 0; k < part_of_ray.size(); ++k) of_part[part_of_ray[k]] += occlusion_[k];
    double sum = 0.0;
    for (const double value : of_part) sum += value;
    const double mean = sum / rays;
    double spread = 0.0;
    for (int part = 0; part < parts; ++part) {
        const double length = sampler_.length_of(part);
        const double off = of_part[static_cast<std::size_t>(part)] / length - mean;
        spread += length / rays * off * (length / rays * off);
    }
    const double error = parts > 1 ? std::sqrt(spread * parts / (parts - 1)) : 0.5;
    return {static_cast<float>(std::clamp(1.0 - mean, 0.0, 1.0)), static_cast<float>(error),
            static_cast<float>(surface.depth_m)};
}

void PixelTracer::append_last_rays(std::vector<RTCRay>& rays) const {
    for (std::size_t k = 0; k < static_cast<std::size_t>(sampler_.rays()); ++k) {
        rays.push_back(ray_from(glm::vec3(start_m_), {x_[k], y_[k], z_[k]}, 0.0F,
                                static_cast<float>(options_.radius_m)));
    }
}

TracedPixel PixelTracer::trace(int x, int y) {
    Surface surface;
    if (!find_surface(x, y, surface)) return {1.0F, 0.0F, kBackgroundDepth_m};
    const std::uint64_t scramble = mixed_bits(options_.seed) ^ pixels_.number(x, y);
    sampler_.directions(mixed_bits(scramble), frame_about(surface.normal), x_.data(), y_.data(),
                        z_.data());
    start_m_ = surface.start_m;
    if (options_.falloff == Falloff::kNone) {
        cast_occlusion(surface);
    } else {
        cast_falloff(surface);
    }
    if (options_.normal == NormalKind::kShading) {
        const glm::vec3 n = surface.geometric_normal;
        for (std::size_t k = 0; k < static_cast<std::size_t>(sampler_.rays()); ++k) {
            if (n.x * x_[k] + n.y * y_[k] + n.z * z_[k] < 0.0F) occlusion_[k] = 1.0F;
        }
    }
    return gathered(surface);
}

}  // namespace obscura::renderer
