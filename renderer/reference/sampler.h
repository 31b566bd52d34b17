// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace obscura::renderer {

/// Directions over the hemisphere about +Z with density cos / pi: Owen-scrambled points of the
/// two-dimensional Sobol sequence on Shirley and Chiu's (1997) concentric map of the square to the
/// disc, lifted to the hemisphere (Malley). A pixel's rays are split into parts, each a scrambled
/// sequence of its own, independent of the others: their spread tells the standard error, which no
/// single scrambled point set can.
class HemisphereSampler {
  public:
    explicit HemisphereSampler(int rays);

    [[nodiscard]] int rays() const { return rays_; }
    [[nodiscard]] int parts() const { return static_cast<int>(first_.size()) - 1; }
    /// The first ray of a part; of part parts(), the number of rays.
    [[nodiscard]] int first_of(int part) const { return first_[static_cast<std::size_t>(part)]; }

    /// All of a pixel's directions as unit vectors; `x`, `y` and `z` have room for rays() values.
    /// `scramble` differs from pixel to pixel.
    void directions(std::uint64_t scramble, float* x, float* y, float* z) const;

  private:
    int rays_;
    std::vector<int> first_;            ///< of each part, and rays_
    std::vector<std::uint32_t> sobol_;  ///< second dimension, bits reversed; the first is the index
};

/// A hash of 64 bits (SplitMix64's finaliser, Steele, Lea and Flood 2014).
[[nodiscard]] constexpr std::uint64_t mixed_bits(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15ULL;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
    return value ^ (value >> 31);
}

/// Owen's nested uniform scramble (1995) of a 32-bit binary fraction whose bits are reversed, by
/// hashing (Laine and Karras 2011; constants of Burley 2020, section 3.2). Gives the bits in their
/// usual order.
[[nodiscard]] std::uint32_t owen_scrambled(std::uint32_t reversed, std::uint32_t seed);

}  // namespace obscura::renderer
