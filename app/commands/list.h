// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/commands/command.h"

namespace obscura::app {

// One line a command; each is defined in the file of its name.
Command analyze_command();
Command ao_command();
Command demo_command();
Command run_command();
Command check_command();
Command explore_command();
Command export_command();
Command measure_command();
Command new_command();
Command merge_command();
Command plan_command();
Command power_command();
Command rehearse_command();
Command render_command();
Command scene_command();

/// All commands, in the order of the help.
[[nodiscard]] const std::vector<Command>& commands();

}  // namespace obscura::app
