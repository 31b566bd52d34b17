// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What layers of depth can know of occlusion, on the built-in study's three views of moderate and
// low light, without any error of sampling, filter or resolution: rays from each pixel's surface
// are marched through space, and what each model of what lies behind the layers says of every step
// is held against what the rays really meet.
//   layer_bench [RAYS [WIDTH [STEPS]]]
// A model takes a point for solid that lies behind a layer by less than a thickness, or before the
// back of what the layer shows. Lengths are in R. For each model its RMSE on each view and on all,
// and the exponent of the accessibility that makes it least.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "renderer/passes/shared_constants.h"
#include "renderer/reference/pixel_tracer.h"
#include "renderer/reference/ray_scene.h"
#include "renderer/reference/reference.h"
#include "renderer/scene/camera.h"
#include "stimuli/scenes/builtin_scene.h"

namespace {

using namespace obscura;
using namespace obscura::renderer;

struct Seen {
    const char* scene;
    const char* camera;
    double radius_m;
};
constexpr Seen kViews[] = {
    {"atrium", "nave", 0.8}, {"figures", "pair", 0.2}, {"relic", "front", 0.06}};
constexpr std::size_t kViewCount = std::size(kViews);
constexpr float kNone = INFINITY;
constexpr int kLayers = 3;

/// How solid a model takes what layers show to be: thickness in R of each, 0: it has not the layer;
/// kToBack: as thick as it is, at most `thickest`.
constexpr float kToBack = -1.0F;
struct Model {
    const char* name;
    std::array<float, kLayers> thickness;
    float thickest = 1.0e9F;
};
constexpr Model kModels[] = {
    {"one layer, .25", {0.25F, 0, 0}},
    {"one layer, .5", {0.5F, 0, 0}},
    {"one layer, 1", {1.0F, 0, 0}},
    {"one layer, to its back", {kToBack, 0, 0}},
    {"one layer, to its back or .5", {kToBack, 0, 0}, 0.5F},
    {"one layer, to its back or 1", {kToBack, 0, 0}, 1.0F},
    {"one layer, to its back or 2", {kToBack, 0, 0}, 2.0F},
    {"two layers, .25 .25", {0.25F, 0.25F, 0}},
    {"two layers, .25 .5", {0.25F, 0.5F, 0}},
    {"two layers, .5 .25", {0.5F, 0.25F, 0}},
    {"two layers, .5 .5", {0.5F, 0.5F, 0}},
    {"two layers, .5 1", {0.5F, 1.0F, 0}},
    {"two layers, back .5", {kToBack, 0.5F, 0}},
    {"two layers, back 1", {kToBack, 1.0F, 0}},
    {"two layers, back back", {kToBack, kToBack, 0}},
    {"two layers, back back, at most 1", {kToBack, kToBack, 0}, 1.0F},
    {"three layers, .25 .25 .5", {0.25F, 0.25F, 0.5F}},
    {"three layers, .5 .5 .5", {0.5F, 0.5F, 0.5F}},
    {"three layers, back back .5", {kToBack, kToBack, 0.5F}},
    {"three layers, back back back", {kToBack, kToBack, kToBack}},
    {"all but what is outside the image", {}},
};
constexpr std::size_t kModelCount = std::size(kModels);
static_assert(kModelCount <= 32);
constexpr float kSeparation = 0.02F;  // of R, between layers

/// Fronts and backs along rays of the eye.
class EyeRays {
  public:
    EyeRays(const RayScene& scene, const Camera& camera, int width, int height)
        : scene_(scene),
          matrices_(matrices_of(camera, width, height)),
          eye_m_(glm::vec3(glm::dvec3(camera.position_m) - scene.origin_m())),
          near_m_(camera.near_m) {}

    /// The depth of a point, and the ray of the eye through it for each metre of depth; kNone where
    /// it is not in the image.
    float depth_of(const glm::vec3& at, glm::vec3& per_m) const {
        const glm::vec3 from_eye = at - eye_m_;
        const glm::vec3 view = glm::mat3(matrices_.view_from_world) * from_eye;
        const float depth_m = -view.z;
        if (!(depth_m > near_m_)) return kNone;
        const glm::vec2 place = glm::vec2(view) / depth_m - matrices_.ray_offset;
        per_m = from_eye / depth_m;
        const bool inside = std::abs(place.x) <= matrices_.ray_scale.x &&
                            std::abs(place.y) <= matrices_.ray_scale.y;
        return inside ? depth_m : kNone;
    }

    /// The depth of the nearest front between two depths, or of the nearest back.
    float next(const glm::vec3& per_m, float from_m, float to_m, bool back) const {
        for (int tries = 0; tries < 8 && to_m > from_m; ++tries) {
            RTCRayHit hit{};
            hit.ray.org_x = eye_m_.x;
            hit.ray.org_y = eye_m_.y;
            hit.ray.org_z = eye_m_.z;
            hit.ray.dir_x = per_m.x;
            hit.ray.dir_y = per_m.y;
            hit.ray.dir_z = per_m.z;
            hit.ray.tnear = from_m;
            hit.ray.tfar = to_m;
            hit.ray.mask = ~0U;
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            RayScene::Context context(!back);
            rtcIntersect1(scene_.embree(), &context, &hit);
            if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return kNone;
            const glm::vec3 face(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z);
            if (!back || glm::dot(face, per_m) > 0.0F) return hit.ray.tfar;
            from_m = hit.ray.tfar * (1.0F + 1.0e-6F);
        }
        return kNone;
    }
    /// Whether what a ray meets first lies in the image.
    [[nodiscard]] bool meets_in_image(const RTCRay& ray) const {
        RTCRayHit hit{ray, {}};
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RayScene::Context context(false);
        rtcIntersect1(scene_.embree(), &context, &hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
        glm::vec3 per_m;
        const glm::vec3 at = glm::vec3(ray.org_x, ray.org_y, ray.org_z) +
                             hit.ray.tfar * glm::vec3(ray.dir_x, ray.dir_y, ray.dir_z);
        return !std::isinf(depth_of(at, per_m));
    }
    [[nodiscard]] float near_m() const { return near_m_; }

  private:
    const RayScene& scene_;
    CameraMatrices matrices_;
    glm::vec3 eye_m_;
    float near_m_;
};

/// Which models take a point for solid, a bit each.
std::uint32_t solid_at(const EyeRays& eye, const glm::vec3& at, float radius_m) {
    glm::vec3 per_m;
    const float depth_m = eye.depth_of(at, per_m);
    if (std::isinf(depth_m)) return 0;
    std::uint32_t solid = 0;
    float from_m = eye.near_m();
    for (std::size_t layer = 0; layer < kLayers; ++layer) {
        const float front_m = eye.next(per_m, from_m, depth_m * (1.0F - 1.0e-5F), false);
        if (std::isinf(front_m)) break;
        const float behind_m = depth_m - front_m;
        const float begin_m = front_m + 1.0e-5F * front_m;
        const bool before_back = std::isinf(eye.next(per_m, begin_m, depth_m, true));
        for (std::size_t m = 0; m < kModelCount; ++m) {
            const float thickness = kModels[m].thickness[layer];
            const bool is = thickness == kToBack
                                ? before_back && behind_m < kModels[m].thickest * radius_m
                                : behind_m < thickness * radius_m;
            if (is) solid |= 1U << m;
        }
        from_m = front_m + kSeparation * radius_m;
    }
    return solid;
}

/// What of a pixel's rays is open: really, and by each model.
struct Opened {
    float truth = 1.0F;
    std::array<float, kModelCount> model{};
};

std::vector<Opened> march(const Seen& seen, int rays, int width, int steps) {
    const Scene scene = stimuli::find_builtin_scene(seen.scene)->build();
    const ReferenceScene reference(scene);
    const Camera& camera = *scene.find_camera(seen.camera);
    const int height = width * 9 / 16;
    const PixelRays pixels(camera, width, height, reference.rays().origin_m());
    const HemisphereSampler sampler(rays);
    ReferenceOptions options;
    options.radius_m = seen.radius_m;
    options.rays = rays;
    PixelTracer tracer(reference.rays(), pixels, options, sampler);
    const EyeRays eye(reference.rays(), camera, width, height);
    const auto radius_m = static_cast<float>(seen.radius_m);
    std::vector<Opened> all;
    std::vector<RTCRay> cast;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const TracedPixel pixel = tracer.trace(x, y);
            if (pixel.depth_m >= kBackgroundLimit_m) continue;
            cast.clear();
            tracer.append_last_rays(cast);
            Opened& opened = all.emplace_back();
            opened.truth = pixel.accessibility;
            for (const RTCRay& ray : cast) {
                const glm::vec3 from(ray.org_x, ray.org_y, ray.org_z);
                const glm::vec3 by(ray.dir_x, ray.dir_y, ray.dir_z);
                std::uint32_t solid = eye.meets_in_image(ray) ? 1U << (kModelCount - 1) : 0;
                for (int step = 0; step < steps; ++step) {
                    const float share =
                        (static_cast<float>(step) + 0.5F) / static_cast<float>(steps);
                    solid |= solid_at(eye, from + share * radius_m * by, radius_m);
                }
                for (std::size_t m = 0; m < kModelCount; ++m) {
                    opened.model[m] +=
                        (solid >> m & 1U) != 0 ? 0.0F : 1.0F / static_cast<float>(rays);
                }
            }
        }
    }
    return all;
}

double mean_square(const std::vector<Opened>& all, std::size_t model, double power) {
    double sum = 0.0;
    for (const Opened& opened : all) {
        const double value = std::pow(std::min<double>(opened.model[model], 1.0), power);
        sum += (value - opened.truth) * (value - opened.truth);
    }
    return sum / static_cast<double>(all.size());
}

}  // namespace

int main(int count, char** arguments) {
    const auto number = [&](int i, int otherwise) {
        return count > i ? std::atoi(arguments[i]) : otherwise;
    };
    const int rays = number(1, 32);
    std::array<std::vector<Opened>, kViewCount> views;
    for (std::size_t v = 0; v < kViewCount; ++v) {
        views[v] = march(kViews[v], rays, number(2, 160), number(3, 24));
    }
    fmt::print("{:34}{:>8}{:>8}{:>8}{:>8}{:>10}\n", "model", "nave", "pair", "front", "all",
               "exponent");
    for (std::size_t m = 0; m < kModelCount; ++m) {
        double least = INFINITY;
        double best = 1.0;
        for (double power = 0.6; power < 2.0; power += 0.1) {
            double sum = 0.0;
            for (const auto& view : views) sum += mean_square(view, m, power);
            if (sum >= least) continue;
            least = sum;
            best = power;
        }
        fmt::print("{:34}", kModels[m].name);
        for (const auto& view : views) fmt::print("{:8.4f}", std::sqrt(mean_square(view, m, best)));
        fmt::print("{:8.4f}{:10.1f}\n", std::sqrt(least / kViewCount), best);
    }
    return 0;
}
