// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/good_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/backs.h"
#include "renderer/reference/reference.h"

namespace obscura::stimuli {
namespace {

using renderer::Camera;

constexpr int kWidth = 48;
constexpr int kHeight = 27;
constexpr int kRays = 8;
constexpr float kFov_rad = 0.25F * std::numbers::pi_v<float>;
constexpr float kEye_m = 1.6F;  // of someone who stands
/// The radius of the rays that judge, as a share of the scene's diagonal.
constexpr float kReach = 0.04F;

struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{-std::numeric_limits<float>::max()};
    [[nodiscard]] glm::vec3 middle() const { return 0.5F * (low + high); }
    [[nodiscard]] glm::vec3 size() const { return high - low; }
    [[nodiscard]] float diagonal() const { return glm::length(size()); }
};

Bounds bounds_of(const renderer::Scene& scene) {
    Bounds bounds;
    for (const renderer::Mesh& mesh : scene.meshes) {
        for (const std::uint32_t index : mesh.indices) {
            const glm::vec3& at = mesh.vertices[index].position_m;
            if (!std::isfinite(at.x + at.y + at.z)) continue;
            bounds.low = glm::min(bounds.low, at);
            bounds.high = glm::max(bounds.high, at);
        }
    }
    return bounds;
}

Camera looking(const glm::vec3& from, const glm::vec3& at, float diagonal_m) {
    Camera camera;
    camera.position_m = from;
    camera.target_m = at;
    camera.vertical_fov_rad = kFov_rad;
    camera.near_m = std::clamp(0.002F * diagonal_m, 1e-4F, 0.1F);
    camera.far_m = std::max(100.0F, 3.0F * diagonal_m);
    return camera;
}

/// From all around, near enough to fill the image or a little nearer.
void add_around(const Bounds& bounds, std::vector<Camera>& cameras) {
    const float fit_m = 0.5F * bounds.diagonal() / std::sin(0.5F * kFov_rad);
    for (const float share : {0.55F, 0.8F, 1.0F}) {
        for (const float up_rad : {0.1F, 0.35F, 0.7F}) {
            for (int i = 0; i < 12; ++i) {
                const float turn = static_cast<float>(i) * std::numbers::pi_v<float> / 6.0F;
                const glm::vec3 away(std::cos(up_rad) * std::sin(turn), std::sin(up_rad),
                                     std::cos(up_rad) * std::cos(turn));
                cameras.push_back(looking(bounds.middle() + share * fit_m * away, bounds.middle(),
                                          bounds.diagonal()));
            }
        }
    }
}

/// Whether someone could stand in it.
bool is_place(const Bounds& bounds) {
    return std::min(bounds.size().x, bounds.size().z) > 3.0F && bounds.size().y > 1.0F;
}

/// At eye height, on a grid within the scene, in eight directions.
void add_within(const Bounds& bounds, std::vector<Camera>& cameras) {
    const glm::vec3 size = bounds.size();
    const float eye = bounds.low.y + std::min(kEye_m, 0.45F * size.y);
    constexpr int kGrid = 4;
    for (int x = 0; x < kGrid; ++x) {
        for (int z = 0; z < kGrid; ++z) {
            const glm::vec3 from(bounds.low.x + size.x * (static_cast<float>(x) + 0.5F) / kGrid,
                                 eye,
                                 bounds.low.z + size.z * (static_cast<float>(z) + 0.5F) / kGrid);
            for (int i = 0; i < 8; ++i) {
                const float turn = static_cast<float>(i) * std::numbers::pi_v<float> / 4.0F;
                const glm::vec3 towards(std::sin(turn), -0.07F, std::cos(turn));
                cameras.push_back(
                    looking(from, from + 0.3F * bounds.diagonal() * towards, bounds.diagonal()));
            }
        }
    }
}

struct Judged {
    FoundView view;
    double score = 0.0;
};

Judged judged(const renderer::ReferenceScene& rays, const Camera& camera, const Bounds& bounds) {
    renderer::ReferenceOptions options;
    options.rays = kRays;
    options.radius_m = static_cast<double>(kReach * bounds.diagonal());
    const renderer::ReferenceImage image = rays.trace(camera, kWidth, kHeight, options);
    double count = 0.0;
    double open = 0.0;
    double square = 0.0;
    double depth = 0.0;
    double depth_square = 0.0;
    double near = 0.0;
    double border = 0.0;
    for (std::size_t i = 0; i < image.accessibility.size(); ++i) {
        if (!(image.depth_m[i] < kBackgroundLimit_m)) continue;
        const double a = static_cast<double>(image.accessibility[i]);
        const double log_z = std::log(static_cast<double>(image.depth_m[i]));
        count += 1.0;
        const int x = static_cast<int>(i) % kWidth;
        const int y = static_cast<int>(i) / kWidth;
        border += x == 0 || y == 0 || x == kWidth - 1 || y == kHeight - 1 ? 1.0 : 0.0;
        open += a;
        square += a * a;
        depth += log_z;
        depth_square += log_z * log_z;
        near += image.depth_m[i] < 0.03F * bounds.diagonal() ? 1.0 : 0.0;
    }
    Judged result;
    result.view.camera = camera;
    if (count == 0.0) return result;
    result.view.seen = count / static_cast<double>(image.accessibility.size());
    result.view.occluded = 1.0 - open / count;
    result.view.spread = std::sqrt(std::max(square / count - open / count * open / count, 0.0));
    const double depths =
        std::sqrt(std::max(depth_square / count - depth / count * depth / count, 0.0));
    // A thing is shown whole; a place goes on beyond the image.
    const double cut = border / static_cast<double>(2 * (kWidth + kHeight) - 4);
    const double whole = is_place(bounds) ? 1.0 : std::max(0.05, 1.0 - 12.0 * cut);
    // What fills the image from near by shows little of the scene.
    const double far_enough =
        std::min(1.0, std::exp(depth / count) / (0.25 * static_cast<double>(bounds.diagonal())));
    // From within a wall or a body nearly all is dark and near.
    const double free =
        std::max(0.0, 1.0 - near / count) * (result.view.occluded < 0.7 ? 1.0 : 0.1);
    result.score = result.view.seen * result.view.spread * free * whole * far_enough *
                   (0.3 + std::min(depths, 0.7));
    return result;
}

/// Of the best, those come first that see no surface from behind: a camera outside a room looks
/// through its walls.
void leave_backs(const renderer::Scene& scene, std::vector<Judged>& all) {
    const std::size_t looked_at = std::min<std::size_t>(all.size(), 60);
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < looked_at; ++i) cameras.push_back(all[i].view.camera);
    const std::vector<double> shares =
        renderer::shares_of_backs(scene, cameras, renderer::Backs::kOfSingleSided);
    for (std::size_t i = 0; i < looked_at; ++i)
        all[i].score *= std::max(1.0 - 10.0 * shares[i], 0.0);
    std::stable_sort(all.begin(), all.end(),
                     [](const Judged& a, const Judged& b) { return a.score > b.score; });
}

bool differs(const Camera& a, const Camera& b, const Bounds& bounds) {
    const float cosine = glm::dot(glm::normalize(a.target_m - a.position_m),
                                  glm::normalize(b.target_m - b.position_m));
    return cosine < 0.8F || glm::distance(a.position_m, b.position_m) > 0.25F * bounds.diagonal();
}

/// Four digits of the longest of a point's coordinates.
std::string numbers(const glm::vec3& value) {
    const float longest = std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
    const float step =
        longest > 0.0F ? std::pow(10.0F, std::floor(std::log10(longest)) - 3.0F) : 1.0F;
    const auto rounded = [&](float x) { return std::round(x / step) * step + 0.0F; };
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", rounded(value.x), rounded(value.y),
                       rounded(value.z));
}

/// Two digits are enough for a length that a study starts from.
double rounded(double value) { return std::stod(fmt::format("{:.2g}", value)); }

}  // namespace

double fitting_radius_m(const Camera& camera) {
    return rounded(0.04 * static_cast<double>(glm::distance(camera.position_m, camera.target_m)));
}

std::vector<FoundView> find_views(const renderer::Scene& scene, int count) {
    const Bounds bounds = bounds_of(scene);
    const float diagonal_m = bounds.diagonal();
    if (scene.triangle_count() == 0 || !(diagonal_m > 0.0F) || !std::isfinite(diagonal_m)) {
        throw base::bad_input("{}: there is nothing to be seen in it", scene.name);
    }
    std::vector<Camera> cameras;
    add_around(bounds, cameras);
    if (is_place(bounds)) add_within(bounds, cameras);
    const renderer::ReferenceScene rays(scene);
    std::vector<Judged> all;
    for (const Camera& camera : cameras) all.push_back(judged(rays, camera, bounds));
    std::stable_sort(all.begin(), all.end(),
                     [](const Judged& a, const Judged& b) { return a.score > b.score; });
    leave_backs(scene, all);
    std::vector<FoundView> found;
    for (const Judged& next : all) {
        if (next.score <= 0.0 || static_cast<int>(found.size()) == count) break;
        const bool is_new = std::all_of(found.begin(), found.end(), [&](const FoundView& other) {
            return differs(next.view.camera, other.camera, bounds);
        });
        if (is_new) found.push_back(next.view);
    }
    if (found.empty()) {
        // A single wall, say: nothing is occluded, and all that counts is that it is seen.
        std::stable_sort(all.begin(), all.end(), [](const Judged& a, const Judged& b) {
            return a.view.seen > b.view.seen;
        });
        if (all.front().view.seen > 0.0) found.push_back(all.front().view);
    }
    if (found.empty()) throw base::bad_input("{}: no camera sees anything of it", scene.name);
    return found;
}

std::string study_line(const Camera& camera) {
    std::string line =
        fmt::format("camera = {{ position_m = {}, target_m = {}, vertical_fov_deg = {:.4g}",
                    numbers(camera.position_m), numbers(camera.target_m),
                    camera.vertical_fov_rad * 180.0F / std::numbers::pi_v<float>);
    line += fmt::format(", near_m = {:.3g}, far_m = {:.4g} }}", camera.near_m, camera.far_m);
    return line;
}

}  // namespace obscura::stimuli
