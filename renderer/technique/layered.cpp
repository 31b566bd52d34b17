// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "renderer/technique/bitmask.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

Recipe recipe_of(const Variant& variant) {
    const Technique& technique = *find_technique(variant.technique);
    const auto value = [&](const char* name) {
        return variant.value_of(*technique.find_parameter(name));
    };
    Recipe recipe = fan_recipe(variant, "technique/bitmask.glsl", fan_of_slices(variant));
    recipe.separation_m = value("separation") * value("radius_m");
    recipe.second_halvings = static_cast<int>(value("second_halvings"));
    Step& step = recipe.steps.front();
    step.reads.emplace_back(Target::kSecondDepth);
    step.fetches += samples_of_frame(variant);
    step.defines.push_back(fmt::format("LAYER_SHIFT {}", recipe.second_halvings));
    // What these say is in the second layer.
    for (const char* name : {"separation", "second_halvings"}) {
        step.defines.push_back(fmt::format("p_{} {:.9e}", name, value(name)));
    }
    return recipe;
}

}  // namespace

Technique layered_technique() {
    Technique technique;
    technique.name = "layered";
    technique.variant = "Layered";
    technique.citation =
        "`bitmask` on two layers of depth: Mara et al. 2016, Deep G-Buffers; Bavoil and Sainz "
        "2009, "
        "Multi-Layer Dual-Resolution Screen-Space Ambient Occlusion";
    technique.samples = {2, 256, 16, 2, "steps"};
    technique.parameters = bitmask_parameters();
    technique.parameters.push_back({"separation",
                                    "How far behind the first layer the second lies at least",
                                    "of radius_m", 0.0, 20.0, 0.5});
    technique.parameters.push_back({"second_thickness", "Thickness of what the second layer shows",
                                    "of radius_m", 0.0, 20.0, 0.5});
    technique.parameters.push_back({"second_halvings",
                                    "How often the sides of the second layer are halved", "", 0.0,
                                    2.0, 0.0, true, false});
    technique.recipe = recipe_of;
    technique.fitted = {{"reach", 1.034},          {"cut_off", 1.785}, {"thickness", 0.48},
                        {"step_spread", 2.0},      {"power", 1.392},   {"separation", 0.459},
                        {"second_thickness", 1.55}};
    technique.reach = "radius_m";
    technique.model = bitmask_model;
    technique.by_nature = slice_nature();
    return technique;
}

}  // namespace obscura::renderer
