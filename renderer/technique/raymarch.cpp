// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/list.h"
#include "renderer/technique/view_space.h"

namespace obscura::renderer {

Technique make_raymarch() {
    Technique technique;
    technique.name = "raymarch";
    technique.variant = "RayMarching";
    technique.citation = "Jakobsen 2010, Appendix C, after Bavoil and Sainz 2009 (ShaderX7)";
    technique.shader = "technique/raymarch.glsl";
    technique.reads_depth = true;
    technique.reads_normal = true;
    technique.samples = {1, 128, 30, 1};
    technique.fetches_per_sample = 4;  // the steps along each direction
    technique.parameters = view_space_parameters();
    technique.reach = "radius_m";
    technique.model = view_space_model(4);
    technique.by_nature = view_space_nature();
    return technique;
}

}  // namespace obscura::renderer
