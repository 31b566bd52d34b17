// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "renderer/light/shadow.h"
#include "renderer/scene/camera.h"
#include "stimuli/pairs.h"

namespace obscura::stimuli {
namespace {

constexpr float kSeesNothing_m = 1e17F;      // the channel Z holds 1e18 where there is no surface
constexpr float kSameAccessibility = 0.01F;  // a code value or two
constexpr float kFewestPixels = 2.0F;        // a kernel that covers less finds its own pixel only

/// The highest alpha that any part of the material has.
float most_opaque(const renderer::Scene& scene, const renderer::Material& material) {
    if (material.coverage == renderer::Coverage::kOpaque) return 1.0F;
    float alpha = 1.0F;
    if (material.albedo_texture != renderer::kNoTexture) {
        const auto& rgba = scene.textures[static_cast<std::size_t>(material.albedo_texture)].rgba;
        std::uint8_t most = 0;
        for (std::size_t i = 3; i < rgba.size(); i += 4) most = std::max(most, rgba[i]);
        alpha = static_cast<float>(most) / 255.0F;
    }
    return alpha * material.opacity;
}

/// Whether its surfaces are in the depth buffer, of which the techniques know the scene.
bool occludes(const renderer::Scene& scene, const renderer::Material& material) {
    switch (material.coverage) {
        case renderer::Coverage::kOpaque:
            return true;
        case renderer::Coverage::kCutOut:
            return most_opaque(scene, material) >= material.alpha_cutoff;
        case renderer::Coverage::kBlended:
            return false;
    }
    return true;
}

std::string size_of(const renderer::Bounds& bounds) {
    const glm::vec3 size = bounds.high_m - bounds.low_m;
    return fmt::format("{:.3g} x {:.3g} x {:.3g} m", size.x, size.y, size.z);
}

/// Names of materials that have triangles and are not in the depth buffer, with their opacity.
std::string see_through(const renderer::Scene& scene, std::size_t& triangles) {
    std::string names;
    triangles = 0;
    std::vector<bool> told(scene.materials.size());
    for (const renderer::Mesh& mesh : scene.meshes) {
        const renderer::Material& material = scene.materials[mesh.material];
        if (occludes(scene, material)) continue;
        triangles += mesh.indices.size() / 3;
        if (told[mesh.material]) continue;
        told[mesh.material] = true;
        names += fmt::format("{}\"{}\" {:.3g}", names.empty() ? "" : ", ", material.name,
                             most_opaque(scene, material));
    }
    return names;
}

/// Why no pixel shows a surface.
std::string reason_of_empty_view(const renderer::Scene& scene, const renderer::Camera& camera) {
    std::size_t triangles = 0;
    const std::string names = see_through(scene, triangles);
    if (triangles == scene.triangle_count()) {
        return "every surface of its scene is transparent (opacity of material " + names +
               "), and there is nothing to occlude";
    }
    const std::string besides =
        triangles == 0 ? "" : "; transparent is what has the opacity of material " + names;
    const renderer::Bounds bounds = renderer::bounds_of(scene);
    const glm::vec3 ahead = glm::normalize(camera.target_m - camera.position_m);
    float nearest_m = INFINITY;
    float farthest_m = -INFINITY;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place((corner & 1) != 0 ? bounds.high_m.x : bounds.low_m.x,
                              (corner & 2) != 0 ? bounds.high_m.y : bounds.low_m.y,
                              (corner & 4) != 0 ? bounds.high_m.z : bounds.low_m.z);
        const float depth_m = glm::dot(place - camera.position_m, ahead);
        nearest_m = std::min(nearest_m, depth_m);
        farthest_m = std::max(farthest_m, depth_m);
    }
    const std::string nothing = "its camera sees no surface: the scene of " + size_of(bounds);
    if (farthest_m < camera.near_m) return nothing + " lies behind it" + besides;
    if (nearest_m > camera.far_m) {
        return fmt::format("{} begins {:.3g} m before it, beyond its far_m of {:.3g} m{}", nothing,
                           nearest_m, camera.far_m, besides);
    }
    return nothing + " lies outside of its frame" + besides;
}

/// What the sides' radii are against what the camera sees; empty where they are of its size.
std::string reason_of_radius(const Condition& condition, const renderer::Scene& scene,
                             const renderer::Camera& camera, int height, float median_m) {
    const renderer::Bounds bounds = renderer::bounds_of(scene);
    const float pixels_of_m =
        0.5F * static_cast<float>(height) / (std::tan(0.5F * camera.vertical_fov_rad) * median_m);
    for (const renderer::Variant* side : {&condition.b, &condition.a}) {
        const renderer::Technique* technique = renderer::find_technique(side->technique);
        const renderer::Parameter* radius =
            technique == nullptr ? nullptr : technique->find_parameter("radius_m");
        if (radius == nullptr) continue;
        const auto radius_m = static_cast<float>(side->value_of(*radius));
        const char letter = side == &condition.a ? 'a' : 'b';
        if (radius_m * pixels_of_m < kFewestPixels) {
            return fmt::format(
                "radius_m {:.3g} of {} covers {:.2g} pixels at {:.3g} m, the median distance of "
                "what its camera sees in a scene of {}; the scene's key scale says how many metres "
                "its unit has",
                radius_m, letter, radius_m * pixels_of_m, median_m, size_of(bounds));
        }
        if (radius_m > glm::distance(bounds.low_m, bounds.high_m)) {
            return fmt::format("radius_m {:.3g} of {} is larger than its whole scene of {}",
                               radius_m, letter, size_of(bounds));
        }
    }
    return "";
}

/// What the pixels that show a surface have of accessibility and light.
struct Seen {
    std::vector<float> depths_m;
    float least_open = 1.0F;
    std::size_t apart = 0;  ///< pixels whose accessibility is not the same
    double light = 0.0;     ///< mean of albedo times light, before accessibility
};

Seen seen_by(const PairBuffers& buffers) {
    Seen seen;
    const std::vector<float>& depth_m = *buffers.a.find("Z");
    const std::vector<float>& open_a = *buffers.a.find("ao.Y");
    const std::vector<float>& open_b = *buffers.b.find("ao.Y");
    for (std::size_t i = 0; i < depth_m.size(); ++i) {
        if (!(depth_m[i] < kSeesNothing_m)) continue;
        seen.depths_m.push_back(depth_m[i]);
        seen.least_open = std::min({seen.least_open, open_a[i], open_b[i]});
        seen.apart += std::abs(open_a[i] - open_b[i]) > kSameAccessibility ? 1 : 0;
        for (const char* channel : {".R", ".G", ".B"}) {
            seen.light += (*buffers.a.find(std::string("albedo") + channel))[i] *
                          (*buffers.a.find(std::string("light") + channel))[i] / 3.0F;
        }
    }
    seen.light /= std::max<double>(1.0, static_cast<double>(seen.depths_m.size()));
    return seen;
}

}  // namespace

std::string reason_of_likeness(const Condition& condition, const renderer::Scene& scene,
                               const renderer::Camera& camera, const PairBuffers& buffers) {
    Seen seen = seen_by(buffers);
    if (seen.depths_m.empty()) return reason_of_empty_view(scene, camera);
    const auto middle =
        seen.depths_m.begin() + static_cast<std::ptrdiff_t>(seen.depths_m.size() / 2);
    std::nth_element(seen.depths_m.begin(), middle, seen.depths_m.end());
    const double pixels = static_cast<double>(buffers.a.width) * buffers.a.height;
    const std::string in_view =
        fmt::format("{:.3g} % of the pixels show a surface",
                    100.0 * static_cast<double>(seen.depths_m.size()) / pixels);
    std::string radius = reason_of_radius(condition, scene, camera, buffers.a.height, *middle);
    if (seen.least_open > 1.0F - kSameAccessibility) {
        return "nothing that its camera sees is occluded, accessibility is 1 on both sides" +
               (radius.empty() ? " (" + in_view + ")" : ": " + radius);
    }
    const double apart = 100.0 * static_cast<double>(seen.apart) / pixels;
    if (apart < 100.0 * kLeastVisible) {
        return fmt::format(
            "both sides have the same accessibility ({:.2g} % of the pixels are {} "
            "apart or more, {}){}",
            apart, kSameAccessibility, in_view, radius.empty() ? "" : ": " + radius);
    }
    if (!radius.empty()) return radius;
    return fmt::format(
        "accessibility differs in {:.3g} % of the pixels, and the light hides it: "
        "surfaces reflect {:.2g} on average before it, where 0 is black and 1 is "
        "white before exposure",
        apart, seen.light);
}

}  // namespace obscura::stimuli
