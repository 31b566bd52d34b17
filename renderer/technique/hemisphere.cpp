// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/hemisphere.h"

#include <fmt/format.h>

#include <cmath>

#include "renderer/technique/disc.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    const Technique& technique = *find_technique(variant.technique);
    const double shortest = variant.value_of(*technique.find_parameter("shortest"));
    Recipe recipe;
    recipe.tables = {rotation_table(variant.noise)};
    Step step =
        accessibility_step(variant, "technique/hemisphere.glsl",
                           {Target::kDepth, Target::kPosition, Target::kNormal, "rotations"},
                           samples_of_frame(variant) + 3);
    step.defines.push_back(
        points_define(part_of(hemisphere_kernel(variant.samples, shortest), variant)));
    step.defines.push_back(fmt::format("p_shortest {:.9e}", shortest));
    recipe.steps = {step};
    return recipe;
}

}  // namespace

std::vector<glm::vec3> hemisphere_kernel(int count, double shortest) {
    std::vector<glm::vec3> kernel;
    for (const DiscPoint& point : disc_kernel(count)) {
        const double x = static_cast<double>(point.x);
        const double y = static_cast<double>(point.y);
        const double z = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
        const double step = static_cast<double>(kernel.size()) * std::sqrt(2.0);
        const double length = shortest + (1.0 - shortest) * (step - std::floor(step));
        kernel.emplace_back(length * x, length * y, length * z);
    }
    return kernel;
}

Technique hemisphere_technique() {
    Technique technique;
    technique.name = "hemisphere";
    technique.variant = "Hemisphere";
    technique.citation = "Whinham 2017, 2.7 and Appendix B.1; as in Sunet 2018, 4.3.2";
    technique.samples = {4, 128, 16, 1};
    technique.parameters = {
        {"radius_m", "Radius of the hemisphere", "m", 0.0, 1000.0, 0.5},
        {"shortest", "Length of the shortest sample; the others lie evenly up to the radius",
         "of radius_m", 0.0, 1.0, 1.0, false, false},
        {"bias", "How far before a sample a surface must lie to hide it", "of radius_m", 0.0, 1.0,
         0.025},
        {"range_check", "1: a surface farther than the radius from the pixel's depth hides nothing",
         "", 0.0, 1.0, 0.0, true, false},
        slice_power(),
    };
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = hemisphere_model;
    technique.by_nature = slice_nature();
    technique.by_nature[Ideal::kOpenFacing] =
        "without the range check all that is nearer to the camera hides a sample: a halo";
    technique.by_nature[Ideal::kOpenTilted] =
        "a texel's depth is that of its middle, and a normal has 8 bits: on a steep surface what "
        "lies beside a sample hides it";
    return technique;
}

}  // namespace obscura::renderer
