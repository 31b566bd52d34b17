// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/list.h"

namespace obscura::app {

const std::vector<Command>& commands() {
    static const std::vector<Command> list = {
        demo_command(),    new_command(),      run_command(),     render_command(),
        plan_command(),    rehearse_command(), export_command(),  merge_command(),
        analyze_command(), power_command(),    check_command(),   ao_command(),
        measure_command(), scene_command(),    explore_command(),
    };
    return list;
}

}  // namespace obscura::app
