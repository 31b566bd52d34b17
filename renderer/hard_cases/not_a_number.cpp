// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "renderer/base/error.h"
#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

constexpr double kCheckedRadius_m = 0.3;

enum class Normals { kSound, kZero, kOpposite };

Scene scene_with(Normals normals) {
    Scene scene = shapes::clutter();
    for (Mesh& mesh : scene.meshes) {
        for (Vertex& vertex : mesh.vertices) {
            if (normals == Normals::kZero) vertex.normal = glm::vec3(0.0F);
            // Along the view ray, away from the camera, which is at the origin.
            if (normals == Normals::kOpposite) vertex.normal = glm::normalize(vertex.position_m);
        }
    }
    return scene;
}

/// Makes what says how far samples reach `share` as long, and says so.
std::string scale_reach(const Technique& technique, double share, Variant& choice) {
    const Parameter* reach = technique.find_parameter(technique.reach);
    if (reach == nullptr) return "no samples";
    const double value = share * choice.value_of(*reach);
    choice.parameters[reach->name] = value;
    return fmt::format("{} {:g}", reach->name, value);
}

/// Case 6. The float buffer is looked at before the technique's last clamp, which would hide a NaN.
/// An odd size puts a pixel's ray exactly on the view axis.
void run_not_a_number(Bench& bench, const Technique& technique) {
    const int size = bench.options().size_px / 2 * 2 + 1;
    const std::pair<Normals, const char*> kinds[] = {{Normals::kSound, "sound normals"},
                                                     {Normals::kZero, "normals of length 0"},
                                                     {Normals::kOpposite, "normals along the ray"}};
    for (const auto& [normals, what] : kinds) {
        for (const double share : {0.0, 1e-8, 1.0}) {
            bench.allow_uncertain(share < 1.0);
            Variant choice = Bench::settings(technique, kCheckedRadius_m);
            choice.unclamped = true;
            const std::string quantity =
                fmt::format("{}, {}", what, scale_reach(technique, share, choice));
            try {
                const Shot shot = bench.shoot(quantity, scene_with(normals), shapes::camera(5.0F),
                                              choice, size, size);
                int nonfinite = 0;
                for (const float value : shot.accessibility) nonfinite += !std::isfinite(value);
                bench.expect(quantity + ": values that are not finite", 0.0, nonfinite, 0.0);
            } catch (const base::Error& error) {
                bench.expect(quantity + ": refused with a message", 1.0, 1.0, 0.0, error.what());
            }
        }
    }
}

}  // namespace

HardCase not_a_number_case() { return {6, "not a number", run_not_a_number}; }

}  // namespace obscura::renderer
