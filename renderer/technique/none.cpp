// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/technique.h"

namespace obscura::renderer {

Technique none_technique() {
    Technique technique;
    technique.name = "none";
    technique.variant = "None";
    technique.citation = "no ambient occlusion: accessibility is 1 everywhere";
    technique.output = Output::kNothing;
    return technique;
}

}  // namespace obscura::renderer
