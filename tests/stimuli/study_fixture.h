// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stimuli/embedded.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::stimuli {

/// Scenes with the names of the built-in ones and nothing in them: enough to read a study.
inline std::vector<BuiltinScene> test_catalogue() {
    const auto scene = [](const char* id, const char* camera, std::vector<Validity> levels) {
        BuiltinScene made;
        made.id = id;
        made.cameras = {camera};
        made.levels = std::move(levels);
        return made;
    };
    return {scene("relic", "front", {Validity::kLow}),
            scene("atrium", "nave", {Validity::kModerate, Validity::kHigh}),
            scene("figures", "pair", {Validity::kModerate, Validity::kHigh})};
}

inline std::string builtin_text() { return std::string(embedded("studies/jakobsen2010.toml")); }

/// Two conditions, nothing optional; the line numbers are what the tests of bad texts count.
inline constexpr std::string_view kSmallStudy = R"([study]
name = "small"
title = "A title"
question = "Which?"
instructions = "Look."
order = "latin-square"
seed = 7

[[scene]]
id = "court"
source = "atrium"
camera = "nave"
validity = "high"

[[condition]]
id = "one"
scene = "court"
a = { technique = "none" }
b = { technique = "blizzard", radius_m = 0.8 }

[[condition]]
id = "two"
scene = "court"
a = { technique = "crytek", samples = 32 }
b = { technique = "raymarch" }
)";

}  // namespace obscura::stimuli
