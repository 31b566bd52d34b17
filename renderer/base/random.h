// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace obscura::base {

/// The only source of random numbers: std::mt19937_64, whose output the standard fixes, with
/// draws written here because the standard's distributions differ between libraries. The same seed
/// gives the same numbers everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(mixed(seed)) {}

    /// Uniform over all 64-bit values.
    [[nodiscard]] std::uint64_t bits() { return engine_(); }

    /// Uniform over 0 .. count - 1, without modulo bias; count must be at least 1.
    [[nodiscard]] std::uint64_t below(std::uint64_t count) {
        const std::uint64_t excess = (UINT64_MAX % count + 1) % count;
        std::uint64_t value = engine_();
        while (value > UINT64_MAX - excess) value = engine_();
        return value % count;
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    [[nodiscard]] double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

    /// Uniform in [low, high).
    [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Every permutation is equally likely (Fisher and Yates).
    template <typename T>
    void shuffle(std::vector<T>& values) {
        for (std::size_t left = values.size(); left > 1; --left) {
            std::swap(values[left - 1], values[below(left)]);
        }
    }

  private:
    /// SplitMix64's finaliser (Steele, Lea and Flood 2014): near seeds give unrelated streams.
    [[nodiscard]] static std::uint64_t mixed(std::uint64_t value) {
        value += 0x9e3779b97f4a7c15ULL;
        value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
        value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
        return value ^ (value >> 31);
    }

    std::mt19937_64 engine_;
};

}  // namespace obscura::base
