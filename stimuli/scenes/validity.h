// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace obscura::stimuli {

/// Ecological validity of a scene's lighting (Jakobsen 2010, 5.3).
enum class Validity {
    kLow,       ///< constant ambient light only
    kModerate,  ///< irradiance from an environment
    kHigh,      ///< that, and a directional light with shadows
};

inline constexpr std::array kValidities{Validity::kLow, Validity::kModerate, Validity::kHigh};

/// `low`, `moderate` or `high`, as in files.
[[nodiscard]] constexpr std::string_view to_string(Validity validity) {
    switch (validity) {
        case Validity::kLow:
            return "low";
        case Validity::kModerate:
            return "moderate";
        case Validity::kHigh:
            return "high";
    }
    return "";
}

/// The level of that name, or nothing.
[[nodiscard]] constexpr std::optional<Validity> validity_from(std::string_view name) {
    for (const Validity validity : kValidities) {
        if (to_string(validity) == name) return validity;
    }
    return std::nullopt;
}

}  // namespace obscura::stimuli
