// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/ray_scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string_view>

#include "renderer/base/error.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/scene/scene_check.h"

namespace obscura::renderer {
namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A scene that lies far from the origin along an axis is moved there. Where the lowest and the
/// highest coordinate differ by less than a factor of two, subtracting the lowest is exact
/// (Sterbenz's lemma); elsewhere nothing is moved.
double shift_of(float low, float high) {
    if (low > 0.0F && high <= 2.0F * low) return low;
    if (high < 0.0F && low >= 2.0F * high) return high;
    return 0.0;
}

glm::dvec3 origin_of(const Scene& scene) {
    glm::vec3 low(std::numeric_limits<float>::infinity());
    glm::vec3 high(-low);
    for (const Mesh& mesh : scene.meshes) {
        for (const Vertex& vertex : mesh.vertices) {
            if (!is_finite(vertex.position_m)) continue;
            low = glm::min(low, vertex.position_m);
            high = glm::max(high, vertex.position_m);
        }
    }
    return {shift_of(low.x, high.x), shift_of(low.y, high.y), shift_of(low.z, high.z)};
}

/// Whether a triangle can be hit at all.
bool has_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 across =
        glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    return glm::dot(across, across) > 0.0;
}

void read_alpha(const Scene& scene, const Material& material, RayScene::Geometry& geometry) {
    geometry.opacity = material.opacity;
    geometry.alpha_cutoff = material.alpha_cutoff;
    if (material.albedo_texture == kNoTexture) return;
    check_textures(scene, material);
    const Texture& texture = scene.textures[static_cast<std::size_t>(material.albedo_texture)];
    check_texture(scene, texture);
    geometry.alpha_width = texture.width;
    geometry.alpha_height = texture.height;
    for (std::size_t i = 3; i < texture.rgba.size(); i += 4) {
        geometry.alpha.push_back(texture.rgba[i]);
    }
}

/// OpenGL 4.6, 8.14.2: bilinear between the four nearest texel centres, wrapped.
double bilinear(const RayScene::Geometry& geometry, double u, double v) {
    const auto wrapped = [](double texel, int size) {
        const double cell = std::fmod(texel, size);
        return static_cast<std::size_t>(cell < 0.0 ? cell + size : cell);
    };
    const double x = u * geometry.alpha_width - 0.5;
    const double y = v * geometry.alpha_height - 0.5;
    if (!std::isfinite(x) || !std::isfinite(y)) return 1.0;
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto at = [&](double column, double row) {
        return geometry.alpha[wrapped(row, geometry.alpha_height) *
                                  static_cast<std::size_t>(geometry.alpha_width) +
                              wrapped(column, geometry.alpha_width)] /
               255.0;
    };
    const double fx = x - left;
    const double fy = y - top;
    return (1.0 - fy) * ((1.0 - fx) * at(left, top) + fx * at(left + 1.0, top)) +
           fy * ((1.0 - fx) * at(left, top + 1.0) + fx * at(left + 1.0, top + 1.0));
}

/// Rejects hits on holes, and hits of the camera's rays on backs that the rasteriser culls.
void judge_hits(const RTCFilterFunctionNArguments* arguments) {
    const auto& geometry = *static_cast<const RayScene::Geometry*>(arguments->geometryUserPtr);
    const bool cull =
        geometry.single_sided && static_cast<const RayScene::Context*>(arguments->context)->camera;
    const unsigned n = arguments->N;
    for (unsigned i = 0; i < n; ++i) {
        if (arguments->valid[i] == 0) continue;
        const glm::vec3 normal(RTCHitN_Ng_x(arguments->hit, n, i),
                               RTCHitN_Ng_y(arguments->hit, n, i),
                               RTCHitN_Ng_z(arguments->hit, n, i));
        const glm::vec3 direction(RTCRayN_dir_x(arguments->ray, n, i),
                                  RTCRayN_dir_y(arguments->ray, n, i),
                                  RTCRayN_dir_z(arguments->ray, n, i));
        const bool back = cull && glm::dot(normal, direction) >= 0.0F;
        const bool hole = geometry.cut_out && !geometry.covers(RTCHitN_primID(arguments->hit, n, i),
                                                               RTCHitN_u(arguments->hit, n, i),
                                                               RTCHitN_v(arguments->hit, n, i));
        if (back || hole) arguments->valid[i] = 0;
    }
}

std::size_t next_number() {
    static std::atomic<std::size_t> next{0};
    return next++;
}

void note(std::string& all, const void* data, std::size_t bytes) {
    all += std::to_string(bytes) + ':';
    all.append(static_cast<const char*>(data), bytes);
}

/// Of everything that rays can meet.
std::string hash_of(const std::vector<std::unique_ptr<RayScene::Geometry>>& geometries,
                    const glm::dvec3& origin_m) {
    std::string all;
    note(all, &origin_m, sizeof origin_m);
    for (const auto& geometry : geometries) {
        note(all, geometry->positions.data(), geometry->positions.size() * sizeof(glm::vec3));
        note(all, geometry->normals.data(), geometry->normals.size() * sizeof(glm::vec3));
        note(all, geometry->indices.data(), geometry->indices.size() * sizeof(std::uint32_t));
        note(all, &geometry->single_sided, sizeof(bool));
        if (geometry->cut_out) {
            note(all, geometry->uvs.data(), geometry->uvs.size() * sizeof(glm::vec2));
            note(all, &geometry->opacity, sizeof(float));
            note(all, &geometry->alpha_cutoff, sizeof(float));
            note(all, &geometry->alpha_width, sizeof(int));
            note(all, geometry->alpha.data(), geometry->alpha.size());
        }
        all = base::sha256_hex(all);
    }
    return base::sha256_hex(all);
}

}  // namespace

bool RayScene::Geometry::covers(unsigned primitive, float u, float v) const {
    if (alpha_width == 0) return opacity >= alpha_cutoff;
    const std::size_t first = 3 * static_cast<std::size_t>(primitive);
    const glm::dvec2 uv = (1.0 - u - v) * glm::dvec2(uvs[indices[first]]) +
                          static_cast<double>(u) * glm::dvec2(uvs[indices[first + 1]]) +
                          static_cast<double>(v) * glm::dvec2(uvs[indices[first + 2]]);
    return bilinear(*this, uv.x, uv.y) * opacity >= alpha_cutoff;
}

const std::string& RayScene::sha256() const {
    std::call_once(hashed_, [this] { sha256_ = hash_of(geometries_, origin_m_); });
    return sha256_;
}

RayScene::RayScene(const Scene& scene, Kernels kernels)
    : origin_m_(origin_of(scene)), number_(next_number()) {
    std::size_t left = 0;
    device_ = rtcNewDevice(kernels == Kernels::kFastest ? nullptr : "max_isa=avx");
    if (device_ == nullptr) {
        throw base::failure("Embree cannot start: error {}",
                            static_cast<int>(rtcGetDeviceError(nullptr)));
    }
    scene_ = rtcNewScene(device_);
    try {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        // Many rays pay for a better tree; those of probes are few.
        rtcSetSceneBuildQuality(scene_, kernels == Kernels::kFastest ? RTC_BUILD_QUALITY_HIGH
                                                                     : RTC_BUILD_QUALITY_MEDIUM);
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) add(scene, i);
        for (const auto& geometry : geometries_) left += geometry->indices.size() / 3;
        if (skipped_ > 0) {
            // Nobody can see a triangle without area; coordinates that are no numbers are a
            // mistake.
            base::log::say(
                broken_ > 0 ? base::log::Level::kWarning : base::log::Level::kInfo,
                fmt::format("scene {}: of {} triangles {} without area and {} with coordinates "
                            "that are not finite are left out of ray tracing",
                            scene.name, scene.triangle_count(), skipped_ - broken_, broken_));
        }
        if (left == 0) {
            throw base::bad_input("scene {} has no surface that rays could meet", scene.name);
        }
        rtcCommitScene(scene_);
        if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE) {
            throw base::failure("Embree cannot build scene {} ({} triangles): error {}", scene.name,
                                left, static_cast<int>(error));
        }
    } catch (...) {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
        throw;
    }
}

RayScene::~RayScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

void RayScene::add(const Scene& scene, std::size_t number) {
    const Mesh& mesh = scene.meshes[number];
    check_mesh(scene, mesh);
    const Material& material = scene.materials[mesh.material];
    if (material.coverage == Coverage::kBlended) return;
    auto geometry = std::make_unique<Geometry>();
    geometry->mesh = number;
    geometry->single_sided = !material.double_sided;
    geometry->cut_out = material.coverage == Coverage::kCutOut;
    for (const Vertex& vertex : mesh.vertices) {
        const bool known = is_finite(vertex.position_m);
        geometry->positions.emplace_back(
            known ? glm::vec3(glm::dvec3(vertex.position_m) - origin_m_) : glm::vec3(0.0F));
        geometry->normals.push_back(vertex.normal);
        if (geometry->cut_out) geometry->uvs.push_back(vertex.uv);
    }
    geometry->positions.emplace_back(0.0F);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* corner = &mesh.indices[i];
        const glm::vec3& a = mesh.vertices[corner[0]].position_m;
        const glm::vec3& b = mesh.vertices[corner[1]].position_m;
        const glm::vec3& c = mesh.vertices[corner[2]].position_m;
        const bool finite = is_finite(a) && is_finite(b) && is_finite(c);
        if (finite && has_area(a, b, c)) {
            geometry->indices.insert(geometry->indices.end(), corner, corner + 3);
        } else {
            ++skipped_;
            if (!finite) ++broken_;
        }
    }
    if (geometry->indices.empty()) return;
    if (geometry->cut_out) read_alpha(scene, material, *geometry);
    attach(std::move(geometry));
}

void RayScene::attach(std::unique_ptr<Geometry> geometry) {
    const RTCGeometry handle = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(handle, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               geometry->positions.data(), 0, sizeof(glm::vec3),
                               geometry->positions.size() - 1);
    rtcSetSharedGeometryBuffer(handle, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               geometry->indices.data(), 0, 3 * sizeof(std::uint32_t),
                               geometry->indices.size() / 3);
    rtcSetGeometryUserData(handle, geometry.get());
    // Occlusion of what has no holes needs no filter, and so runs at full speed.
    if (geometry->single_sided || geometry->cut_out) {
        rtcSetGeometryIntersectFilterFunction(handle, judge_hits);
    }
    if (geometry->cut_out) rtcSetGeometryOccludedFilterFunction(handle, judge_hits);
    rtcCommitGeometry(handle);
    const unsigned id = rtcAttachGeometry(scene_, handle);
    rtcReleaseGeometry(handle);
    if (id != geometries_.size()) {
        throw base::failure("Embree gave geometry {} the number {}", geometries_.size(), id);
    }
    geometries_.push_back(std::move(geometry));
}

RayScene::Triangle RayScene::triangle(unsigned geometry, unsigned primitive) const {
    const Geometry& mesh = *geometries_[geometry];
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t index = mesh.indices[3 * static_cast<std::size_t>(primitive) + i];
        triangle.corner[i] = glm::dvec3(mesh.positions[index]);
        triangle.normal[i] = mesh.normals[index];
    }
    return triangle;
}

}  // namespace obscura::renderer
