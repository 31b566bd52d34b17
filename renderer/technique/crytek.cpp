// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/list.h"

namespace obscura::renderer {

Technique make_crytek() {
    Technique technique;
    technique.name = "crytek";
    technique.variant = "Crytek";
    technique.citation = "Jakobsen 2010, Appendix A, after Kajalin 2009 (ShaderX7)";
    technique.shader = "technique/crytek.glsl";
    technique.reads_depth = true;
    technique.samples = {8, 128, 24, 8};
    technique.fetches_per_sample = 1;
    technique.parameters = {
        {"offset_scale",
         "Length of the offsets before the first sample; each sample multiplies it by 1 + 2.4/N",
         "fraction of the image, and of the depth", 0.0, 1.0, 0.01},
    };
    return technique;
}

}  // namespace obscura::renderer
