// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::base {

/// Whether what goes to standard error may be coloured: it is a terminal that can, and NO_COLOR
/// (no-color.org) is not set.
[[nodiscard]] bool shows_colour();

}  // namespace obscura::base
