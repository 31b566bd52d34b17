// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/kiosk/procedure.h"

namespace obscura::app::kiosk {

/// Seconds of the machine's monotonic clock.
[[nodiscard]] double monotonic_s();

/// Now, as ISO 8601 with milliseconds and Z.
[[nodiscard]] std::string utc_now();

/// ISO 8601 with milliseconds and Z of that many seconds after 1970-01-01T00:00:00Z.
[[nodiscard]] std::string utc_text(double seconds_since_1970);

/// Seconds from one ISO 8601 time with Z to another; 0 where one cannot be read.
[[nodiscard]] double seconds_between(const std::string& from_utc, const std::string& to_utc);

/// An event's moment: now, or a monotonic time a little while ago.
[[nodiscard]] Moment moment_now();
[[nodiscard]] Moment moment_at(double time_s);

/// The moment of what a key or button did then that went down at `pressed_s`.
[[nodiscard]] Moment moment_of_press(double time_s, double pressed_s);

/// Returns as soon after that monotonic time as the machine allows.
void wait_until(double time_s);

}  // namespace obscura::app::kiosk
