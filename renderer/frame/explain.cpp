// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/explain.h"

#include <fmt/format.h>

namespace obscura::renderer {

std::string explanation_of(const Frame& frame) {
    const FramePlan& plan = frame.plan();
    std::string text;
    for (const PassTime& time : by_name(frame.times)) {
        text += fmt::format("  pass    {:14} {:9.2f} ms\n", time.name, time.milliseconds);
    }
    text += fmt::format("  passes  {:14} {:9.2f} ms\n", "in all", frame.milliseconds());
    for (const PlannedTarget& target : plan.targets) {
        text += fmt::format("  buffer  {:14} {:9} bytes  {} {}x{}{}{}\n", target.name, target.bytes,
                            target.format, target.width, target.height,
                            target.layers > 1 ? fmt::format("x{}", target.layers) : "",
                            target.levels > 1 ? fmt::format(", {} levels", target.levels) : "");
    }
    text += fmt::format("  buffers {:14} {:9} bytes\n", "in all", plan.bytes());
    for (const LeftOut& left_out : plan.left_out) {
        text += fmt::format("  without {}: {}\n", left_out.what, left_out.why);
    }
    return text;
}

}  // namespace obscura::renderer
