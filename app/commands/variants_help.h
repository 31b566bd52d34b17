// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::app {

/// Every technique with its samples and parameters, and every denoise filter, from their
/// descriptors, for the foot of a command's help.
[[nodiscard]] std::string variants_help();

}  // namespace obscura::app
