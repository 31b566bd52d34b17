// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/list.h"
#include "renderer/technique/view_space.h"

namespace obscura::renderer {

Technique make_blizzard() {
    Technique technique;
    technique.name = "blizzard";
    technique.variant = "Blizzard";
    technique.citation = "Jakobsen 2010, Appendix B, after Filion and McNaughton 2008";
    technique.shader = "technique/blizzard.glsl";
    technique.reads_depth = true;
    technique.reads_normal = true;
    technique.samples = {1, 128, 24, 1};
    technique.fetches_per_sample = 1;
    technique.parameters = view_space_parameters();
    technique.reach = "radius_m";
    technique.model = view_space_model(1);
    technique.by_nature = view_space_nature();
    return technique;
}

}  // namespace obscura::renderer
