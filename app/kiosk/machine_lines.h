// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/words.h"

namespace obscura::app::kiosk {

/// For the operator: the free disk at `data`, and what `timing`, as session_timing() gives it, says
/// of the times and the screen of this machine.
[[nodiscard]] std::vector<std::string> machine_lines(const stimuli::Words& words,
                                                     const std::filesystem::path& data,
                                                     const std::string& timing);

}  // namespace obscura::app::kiosk
