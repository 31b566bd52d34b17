// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/reference.h"

namespace obscura::renderer {

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
