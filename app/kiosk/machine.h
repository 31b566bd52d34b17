// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::app::kiosk {

/// Distribution and kernel.
[[nodiscard]] std::string operating_system();

/// An id that no other session or participant has: `stem`, the time to the second and 32 random
/// bits of the system, s-20260131T120000Z-0f1e2d3c.
[[nodiscard]] std::string unique_id(const std::string& stem);

}  // namespace obscura::app::kiosk
