// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/recipe/depth_beside.h"

#include <algorithm>

namespace obscura::renderer {
namespace {

bool writes_accessibility(const Step& step) { return step.writes == Target::kAccessibility.name; }
bool reads_accessibility(const Step& step) { return step.reads_buffer(Target::kAccessibility); }

/// Whether there are such steps and all of them can.
bool all_can(const Recipe& recipe, bool (*concerned)(const Step&)) {
    return std::any_of(recipe.steps.begin(), recipe.steps.end(), concerned) &&
           std::all_of(recipe.steps.begin(), recipe.steps.end(), [concerned](const Step& step) {
               return !concerned(step) || (step.depth_beside && step.processor == nullptr);
           });
}

}  // namespace

bool lay_depth_beside(std::string_view ao_format, Recipe& technique, Recipe& filter) {
    if (ao_format != Target::kAccessibility.format || !all_can(technique, writes_accessibility) ||
        !all_can(filter, reads_accessibility)) {
        return false;
    }
    for (Step& step : technique.steps) {
        if (writes_accessibility(step)) step.defines.emplace_back("DEPTH_BESIDE");
    }
    for (Step& step : filter.steps) {
        if (!reads_accessibility(step)) continue;
        step.defines.emplace_back("DEPTH_BESIDE");
        std::erase_if(step.reads,
                      [](const Read& read) { return read.name == Target::kDepth.name; });
        step.fetches /= 2;
    }
    return true;
}

}  // namespace obscura::renderer
