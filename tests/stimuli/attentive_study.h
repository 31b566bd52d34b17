// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {

/// The small study with an attention check, a repeat and a rule; the check begins at line 27.
inline constexpr std::string_view kAttention = R"(
[[condition]]
id = "check"
scene = "court"
catch = "b"
a = { technique = "none" }
b = { technique = "crytek", samples = 64 }

[[condition]]
id = "one-again"
repeats = "one"

[exclusion]
min_catch_correct = 0.8
min_repeat_agreement = 0.5
min_response_time_s = 0.2
)";

inline std::string attentive_text() { return std::string(kSmallStudy) + std::string(kAttention); }

}  // namespace obscura::stimuli
