// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "renderer/frame/frame.h"

namespace obscura::renderer {

/// The passes and steps (ms), buffers (bytes) and omissions of a rendered image, a line each.
/// `known_from` is said of the passes whose results, and times, were taken over.
[[nodiscard]] std::string explanation_of(const Frame& frame, const std::string& known_from = "");

/// Format and size of a buffer: `r32f 1280x720x4, 3 levels`.
[[nodiscard]] std::string form_of(const PlannedTarget& target);

/// Whether the results of the passes of that phase were taken over.
[[nodiscard]] bool is_taken_over(const Frame& frame, Phase phase);

}  // namespace obscura::renderer
