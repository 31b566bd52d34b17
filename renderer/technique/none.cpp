// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/list.h"

namespace obscura::renderer {

Technique make_none() {
    Technique technique;
    technique.name = "none";
    technique.variant = "None";
    technique.citation = "no ambient occlusion: accessibility is 1 everywhere";
    return technique;
}

}  // namespace obscura::renderer
