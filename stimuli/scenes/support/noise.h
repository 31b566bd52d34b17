// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace obscura::stimuli {

// Noise for shapes and textures. All of it is a pure function of position and seed, made from
// integer hashes, so every run and thread sees the same values. Positions are in lattice cells.
// A `period` above 0 makes the lattice repeat after that many cells on that axis, so that a
// texture of that many cells wraps without a seam; 0 means no repetition.

/// A well mixed 32-bit hash of a lattice point.
[[nodiscard]] std::uint32_t hash_lattice(int x, int y, int z, std::uint32_t seed);

/// The hash as a number in [0, 1).
[[nodiscard]] float hash_unit(int x, int y, int z, std::uint32_t seed);

/// Smooth interpolation of random values at the lattice points, [0, 1].
[[nodiscard]] float value_noise(glm::vec2 p, std::uint32_t seed, glm::ivec2 period = {0, 0});
[[nodiscard]] float value_noise(glm::vec3 p, std::uint32_t seed);

/// Gradient noise (Perlin 2002, quintic fade), about [-1, 1], 0 at the lattice points.
[[nodiscard]] float gradient_noise(glm::vec2 p, std::uint32_t seed, glm::ivec2 period = {0, 0});
[[nodiscard]] float gradient_noise(glm::vec3 p, std::uint32_t seed);

/// Sum of `octaves` gradient noises, each at twice the frequency and `gain` times the height of the
/// one before, divided by the sum of heights: about [-1, 1]. The period is that of the first
/// octave.
[[nodiscard]] float fbm(glm::vec2 p, std::uint32_t seed, int octaves, glm::ivec2 period = {0, 0},
                        float gain = 0.5F);
[[nodiscard]] float fbm(glm::vec3 p, std::uint32_t seed, int octaves, float gain = 0.5F);

/// As fbm, of 1 - |noise|: [0, 1] with sharp ridges near 1.
[[nodiscard]] float ridged(glm::vec2 p, std::uint32_t seed, int octaves, glm::ivec2 period = {0, 0},
                           float gain = 0.5F);
[[nodiscard]] float ridged(glm::vec3 p, std::uint32_t seed, int octaves, float gain = 0.5F);

/// fbm of `cells` x `cells` over the unit square as a table: an order of magnitude faster than fbm
/// where a texture needs many of them. Interpolated; repeats at 1, so scales must be whole numbers
/// where the result has to wrap, while offsets are free.
class NoiseTile {
  public:
    explicit NoiseTile(std::uint32_t seed, int cells = 8, int octaves = 5);
    /// About [-1, 1].
    [[nodiscard]] float at(glm::vec2 uv) const;

  private:
    static constexpr int kSize = 512;
    std::vector<float> values_;  // kSize * kSize
};

/// One random point in each lattice cell (Worley 1996).
struct CellularNoise {
    float nearest = 0.0F;      ///< distance to the nearest point, cells
    float second = 0.0F;       ///< distance to the second nearest, >= nearest
    std::uint32_t id = 0;      ///< hash of the nearest point's cell
    glm::vec2 to_point{0.0F};  ///< from p to the nearest point, cells (x and y)
};
[[nodiscard]] CellularNoise cellular(glm::vec2 p, std::uint32_t seed, glm::ivec2 period = {0, 0});
[[nodiscard]] CellularNoise cellular(glm::vec3 p, std::uint32_t seed);

}  // namespace obscura::stimuli
