// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace obscura::app::explorer {

using Rgb = std::array<std::uint8_t, 3>;

/// Colour scales that people with any kind of colour vision can read: lightness alone tells the
/// values of the first two apart, and in the third the two ends differ along blue and yellow, which
/// the common deficiencies leave, and each grows darker from the middle.

/// [0, 1] from black to white.
[[nodiscard]] Rgb grey(float value);
/// [0, 1] from dark violet to yellow: viridis (Smith and van der Walt 2015).
[[nodiscard]] Rgb viridis(float value);
/// [-1, 1] from orange over white to violet-blue: PuOr (Brewer 2003), reversed.
[[nodiscard]] Rgb orange_to_blue(float value);

/// What is not a number, in every scale.
inline constexpr Rgb kNotANumber{255, 0, 255};

}  // namespace obscura::app::explorer
