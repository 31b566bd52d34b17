// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/technique.h"

namespace obscura::renderer {

const Parameter* Technique::find_parameter(std::string_view parameter_name) const {
    for (const Parameter& parameter : parameters) {
        if (parameter.name == parameter_name) return &parameter;
    }
    return nullptr;
}

Recipe Technique::standard_recipe() const {
    return recipe != nullptr ? recipe(standard_variant(*this)) : Recipe{};
}

std::string Technique::why_not(Ideal ideal) const {
    const auto found = by_nature.find(ideal);
    return found != by_nature.end() ? found->second : "";
}

const Technique* find_technique(std::string_view name) {
    for (const Technique& technique : techniques()) {
        if (technique.name == name) return &technique;
    }
    return nullptr;
}

}  // namespace obscura::renderer
