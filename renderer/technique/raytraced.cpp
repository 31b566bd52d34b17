// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/buffer_rays.h"
#include "renderer/reference/reference.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {
namespace {

std::vector<float> traced(const ProcessorWork& work) {
    return trace_from_buffers(work.rays.rays(), work.camera,
                              {work.width, work.height, work.reads[0], work.reads[1]},
                              work.parameters.at("radius_m"), work.samples);
}

Recipe recipe_of(const Variant& variant) {
    Step step = accessibility_step(variant, "technique/raytraced.glsl",
                                   {Target::kDepth, Target::kNormal}, 2);
    step.name = "rays";
    step.cover = Cover::kAll;
    step.processor = traced;
    step.traces = true;
    Recipe recipe;
    recipe.steps = {step};
    return recipe;
}

}  // namespace

Technique raytraced_technique() {
    Technique technique;
    technique.name = "raytraced";
    technique.variant = "RayTraced";
    technique.citation =
        "ray traced from the G-buffer: cosine-weighted visibility within a radius, Owen-scrambled "
        "Sobol points shared by blocks of 4x4 pixels (Owen 1995, Burley 2020); Embree 3 on the "
        "processor, on a GPU a compute shader over a tree by Embree's builder";
    technique.ray_traced = true;
    technique.samples = {1, 64, 4, 1};
    technique.parameters = {
        {"radius_m", "Distance to which surfaces occlude", "m", 0.0, 1.0e6, 0.5, false, false},
    };
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.denoise = "known_error";
    return technique;
}

}  // namespace obscura::renderer
