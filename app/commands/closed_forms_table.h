// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace obscura::app {

/// Prints how the ray-traced reference meets the closed forms, and how its error falls with its
/// rays. Throws check failed when one does not hold.
void print_closed_forms(int rays, std::uint64_t seed);

}  // namespace obscura::app
