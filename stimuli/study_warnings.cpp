// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/study_warnings.h"

#include <fmt/format.h>

namespace obscura::stimuli {

std::vector<std::string> warnings_of(const Study& study) {
    std::vector<std::string> warnings;
    for (const StudyScene& scene : study.scenes) {
        const auto add = [&](const std::string& what) {
            warnings.push_back(fmt::format("scene \"{}\": {}", scene.id, what));
        };
        for (const std::string& note : scene.notes) {
            add(fmt::format("{}: {}", scene.source, note));
        }
        const auto unused = [&](bool given, const char* what) {
            if (given) {
                add(fmt::format("{} no effect at the validity {}", what,
                                to_string(scene.validity)));
            }
        };
        const SceneSettings& settings = scene.settings;
        const bool low = scene.validity == Validity::kLow;
        unused(low && !settings.environment.empty(), "its environment has");
        unused(scene.validity != Validity::kHigh && settings.has_lights(), "its lights have");
        unused(!low && settings.ambient.has_value(), "its ambient light has");
    }
    return warnings;
}

}  // namespace obscura::stimuli
