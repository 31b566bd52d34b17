// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace obscura::analysis {

/// A value, or the sentence that says why there is none. Statistics give this instead of NaN.
template <typename T>
struct Possible {
    std::optional<T> value;
    std::string reason;  ///< empty where there is a value

    Possible(T held) : value(std::move(held)) {}

    [[nodiscard]] static Possible none(std::string why) { return Possible(std::move(why), 0); }
    [[nodiscard]] bool has_value() const { return value.has_value(); }
    [[nodiscard]] const T& operator*() const { return *value; }
    [[nodiscard]] const T* operator->() const { return &*value; }

  private:
    Possible(std::string why, int) : reason(std::move(why)) {}
};

/// The probability of something at least this extreme. `p` is 0 where it is smaller than a double
/// can be; `log10_p` keeps its size also there.
struct PValue {
    double p = 1.0;
    double log10_p = 0.0;
};

/// The largest count taken: sums of two and their squares' ratios stay exact to double precision.
inline constexpr std::int64_t kMaxCount = 1'000'000'000'000;

/// Votes for the two sides of a pair.
struct Votes {
    std::int64_t a = 0;  ///< 0 to kMaxCount
    std::int64_t b = 0;

    [[nodiscard]] std::int64_t n() const { return a + b; }
};

}  // namespace obscura::analysis
