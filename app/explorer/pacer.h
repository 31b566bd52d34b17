// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

namespace obscura::app::explorer {

/// At which part of its size an image is drawn while something moves: the largest of 1, 1/2 and
/// 1/4 that is quick enough, by how long images took.
class Pacer {
  public:
    static constexpr std::array<int, 3> kDivisors{1, 2, 4};

    /// `longest_ms` is what one image may take. On a graphics card the size is always whole.
    Pacer(double longest_ms, bool always_whole);

    /// Width and height are divided by this.
    [[nodiscard]] int divisor() const { return kDivisors[at_]; }
    /// An image at that divisor took so long. Times that are not finite or negative are ignored.
    void took(int divisor, double milliseconds);
    /// The scene, its size or what is drawn changed: what was learnt does not hold any more.
    void forget();

  private:
    /// What an image is thought to take.
    [[nodiscard]] double expected_ms(std::size_t at) const;

    double longest_ms_;
    bool always_whole_;
    std::size_t at_ = 0;
    std::array<std::optional<double>, 3> took_ms_;  ///< lately, by divisor
};

}  // namespace obscura::app::explorer
