// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/reference.h"

namespace obscura::renderer {

Technique reference_technique() {
    Technique technique;
    technique.name = "reference";
    technique.variant = "Reference";
    technique.citation =
        "ray traced: cosine-weighted visibility within a radius, Owen-scrambled Sobol rays "
        "(Owen 1995, Burley 2020)";
    technique.ray_traced = true;
    technique.samples = {1, kMostReferenceRays, 256, 1};
    technique.parameters = {
        {"radius_m", "Distance to which surfaces occlude", "m", 1e-6, 1e6, 0.5},
        {"seed", "Of the rays' directions; a whole number", "", 0.0, 4294967295.0, 1.0, true},
        {"falloff",
         "How a surface at distance t occludes: 0 wholly, 1 by 1 - t/R, 2 by 1 - (t/R)^2", "", 0.0,
         2.0, 0.0, true},
        {"shading_normal", "Whose hemisphere: 0 the triangle's, 1 that of the vertex normals", "",
         0.0, 1.0, 0.0, true},
    };
    return technique;
}

ReferenceOptions reference_options(const Variant& choice) {
    const Technique& technique = *find_technique("reference");
    const auto value = [&](const char* name) {
        return choice.value_of(*technique.find_parameter(name));
    };
    ReferenceOptions options;
    options.rays = choice.samples;
    options.radius_m = value("radius_m");
    options.seed = static_cast<std::uint64_t>(value("seed"));
    options.falloff = static_cast<Falloff>(static_cast<int>(value("falloff")));
    options.normal = value("shading_normal") != 0.0 ? NormalKind::kShading : NormalKind::kGeometric;
    return options;
}

}  // namespace obscura::renderer
