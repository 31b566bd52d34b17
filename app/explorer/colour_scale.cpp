// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/colour_scale.h"

#include <algorithm>
#include <cmath>

namespace obscura::app::explorer {
namespace {

/// Every eighth of matplotlib's table of 256 colours.
constexpr std::array<Rgb, 9> kViridis{Rgb{68, 1, 84}, {71, 44, 122},  {59, 81, 139},
                                      {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                      {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};
/// The eleven classes of ColorBrewer's PuOr, from orange.
constexpr std::array<Rgb, 11> kPuOr{Rgb{127, 59, 8}, {179, 88, 6},    {224, 130, 20},
                                    {253, 184, 99},  {254, 224, 182}, {247, 247, 247},
                                    {216, 218, 235}, {178, 171, 210}, {128, 115, 172},
                                    {84, 39, 136},   {45, 0, 75}};

template <std::size_t Count>
[[nodiscard]] Rgb between(const std::array<Rgb, Count>& colours, float value) {
    if (std::isnan(value)) return kNotANumber;
    const float at = std::clamp(value, 0.0F, 1.0F) * static_cast<float>(Count - 1);
    const auto low = std::min(static_cast<std::size_t>(at), Count - 2);
    const float share = at - static_cast<float>(low);
    Rgb colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto from = static_cast<float>(colours[low][c]);
        const auto to = static_cast<float>(colours[low + 1][c]);
        colour[c] = static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
    }
    return colour;
}

}  // namespace

Rgb grey(float value) {
    if (std::isnan(value)) return kNotANumber;
    const auto code =
        static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
    return {code, code, code};
}

Rgb viridis(float value) { return between(kViridis, value); }

Rgb orange_to_blue(float value) { return between(kPuOr, 0.5F * (value + 1.0F)); }

}  // namespace obscura::app::explorer
