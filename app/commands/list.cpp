// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/list.h"

namespace obscura::app {

const std::vector<Command>& commands() {
    static const std::vector<Command> list = {
        demo_command(),   new_command(),  check_command(),   scene_command(),
        render_command(), plan_command(), power_command(),   rehearse_command(),
        pack_command(),   run_command(),  merge_command(),   analyze_command(),
        export_command(), ao_command(),   measure_command(), explore_command(),
    };
    return list;
}

}  // namespace obscura::app
