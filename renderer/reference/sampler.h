// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace obscura::renderer {

/// Directions over the hemisphere about +Z with density cos / pi: Owen-scrambled points of the
/// two-dimensional Sobol sequence on Shirley and Chiu's (1997) concentric map of the square to the
/// disc, lifted to the hemisphere (Malley). No scrambled point set can tell its own error; the
/// spread between consecutive parts of it can. Each part is as well spread as a sequence of its
/// length, and as together they also fill each other's gaps, that figure is rather too high than
/// too low: by a factor of 1 where rays are few for what they meet, of parts^(1/4) where the edges
/// of occluders decide, more where all is smooth.
class HemisphereSampler {
  public:
    explicit HemisphereSampler(int rays);

    [[nodiscard]] int rays() const { return rays_; }
    /// 8 from 32 rays on, at least four rays each; fewer below.
    [[nodiscard]] int parts() const { return static_cast<int>(lengths_.size()); }
    /// Which part each ray belongs to, and how many rays each part has.
    [[nodiscard]] const std::vector<std::uint8_t>& part_of_ray() const { return part_; }
    [[nodiscard]] int length_of(int part) const { return lengths_[static_cast<std::size_t>(part)]; }

    /// All of a pixel's directions as unit vectors, the hemisphere's axes being the columns of
    /// `frame`; `x`, `y` and `z` have room for rays() values. `scramble` differs from pixel to
    /// pixel. Neighbours in the list are neighbours on the hemisphere: points that share leading
    /// bits share them after Owen's scrambling too, so one order serves every pixel.
    void directions(std::uint64_t scramble, const glm::mat3& frame, float* x, float* y,
                    float* z) const;

  private:
    int rays_;
    std::vector<int> lengths_;  ///< of each part
    // By ray, in the order of the list.
    std::vector<std::uint32_t> first_;   ///< first dimension, bits reversed
    std::vector<std::uint32_t> second_;  ///< second dimension, bits reversed
    std::vector<std::uint8_t> part_;
};

/// The same points for the pixels of a block, which share one scrambled sequence: each pixel's are
/// a part of it, in the order of Morton's curve, and as those of two by two and four by four pixels
/// together are parts of it too, what is averaged over neighbours is as evenly spread as a sequence
/// of that length.
class BlockSampler {
  public:
    static constexpr int kSide = 4;  ///< pixels along a side of a block

    explicit BlockSampler(int rays);

    /// All of a block's directions about +Z, kSide * kSide * rays of them.
    void directions(std::uint64_t scramble, float* x, float* y, float* z) const;
    /// Which part of the block's directions a pixel takes.
    [[nodiscard]] static int part_of(int x, int y);

  private:
    std::vector<std::uint32_t> first_;  ///< dimensions, bits reversed
    std::vector<std::uint32_t> second_;
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
