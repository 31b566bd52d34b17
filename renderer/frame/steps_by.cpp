// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/steps_by.h"

#include <cstdlib>
#include <string>

#include "renderer/base/error.h"
#include "renderer/gl/context.h"

namespace obscura::renderer {

StepsBy steps_by_device() {
    const char* const set = std::getenv("OBSCURA_STEPS");
    const std::string asked = set != nullptr ? set : "";
    if (asked == "fragments") return StepsBy::kFragments;
    if (asked == "compute") return StepsBy::kCompute;
    if (!asked.empty()) {
        throw base::bad_input(
            "OBSCURA_STEPS is \"{}\"; allowed are fragments and compute, or nothing", asked);
    }
    return is_software_renderer() ? StepsBy::kFragments : StepsBy::kCompute;
}

const char* in_words(StepsBy steps) {
    return steps == StepsBy::kCompute ? "compute shaders" : "fragment shaders";
}

}  // namespace obscura::renderer
