// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/explain.h"

#include <fmt/format.h>

#include <algorithm>

namespace obscura::renderer {

bool is_taken_over(const Frame& frame, Phase phase) {
    const std::vector<PassTime>& all = frame.taken_over();
    return std::any_of(all.begin(), all.end(),
                       [phase](const PassTime& time) { return time.phase == phase; });
}

std::string form_of(const PlannedTarget& target) {
    return fmt::format(
        "{} {}x{}{}{}{}", target.format, target.width, target.height,
        target.layers > 1 ? fmt::format("x{}", target.layers) : "",
        target.levels > 1 ? fmt::format(", {} levels", target.levels) : "",
        target.columns > 1 ? fmt::format(", {} columns a texel", target.columns) : "");
}

std::string explanation_of(const Frame& frame, const std::string& known_from) {
    const FramePlan& plan = frame.plan();
    std::string text;
    for (const PassTime& time : by_name(frame.times)) {
        const bool is_known = !known_from.empty() && is_taken_over(frame, time.phase);
        text += fmt::format("  pass    {:14} {:9.2f} ms{}\n", time.name, time.milliseconds,
                            is_known ? "  shared with " + known_from : "");
    }
    text += fmt::format("  passes  {:14} {:9.2f} ms\n", "in all", frame.milliseconds());
    for (const PlannedTarget& target : plan.targets) {
        text += fmt::format("  buffer  {:14} {:9} bytes  {}\n", target.name, target.bytes,
                            form_of(target));
    }
    text += fmt::format("  buffers {:14} {:9} bytes\n", "in all", plan.bytes());
    for (const LeftOut& left_out : plan.left_out) {
        text += fmt::format("  without {}: {}\n", left_out.what, left_out.why);
    }
    return text;
}

}  // namespace obscura::renderer
