// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace obscura::renderer {

/// A number in double precision with a bound on how far the same sum in a shader's single precision
/// may be from it: the running error analysis of Higham 2002, "Accuracy and Stability of Numerical
/// Algorithms", 3.3, with the precision that GLSL 4.50 promises in 4.7.1. A formula written once in
/// `Rounded` gives both, and a comparison of two says what single precision may decide.
struct Rounded {
    double value = 0.0;
    double error = 0.0;  ///< at least 0; infinity where nothing is known

    constexpr Rounded() = default;
    /// A number that a float holds exactly.
    constexpr Rounded(double exact) : value(exact) {}
    constexpr Rounded(double of, double bound) : value(of), error(bound) {}

    [[nodiscard]] constexpr double low() const { return value - error; }
    [[nodiscard]] constexpr double high() const { return value + error; }
    [[nodiscard]] double size() const { return std::abs(value) + error; }
};

/// One unit in the last place of a float, relative. Sums and products may be half of it off; the
/// whole is allowed, for what the spacing at a power of two adds.
inline constexpr double kUlp = 1.1920928955078125e-7;

/// A number that a float holds as nearly as it can: a parameter, a constant of a shader.
[[nodiscard]] inline Rounded nearest_float(double value) { return {value, kUlp * std::abs(value)}; }

inline Rounded operator-(const Rounded& a) { return {-a.value, a.error}; }
inline Rounded operator+(const Rounded& a, const Rounded& b) {
    if (a.value == 0.0 && a.error == 0.0) return b;  // nothing is rounded
    if (b.value == 0.0 && b.error == 0.0) return a;
    const double value = a.value + b.value;
    const double error = a.error + b.error;
    return {value, error + kUlp * (std::abs(value) + error)};
}
inline Rounded operator-(const Rounded& a, const Rounded& b) { return a + -b; }
inline Rounded operator*(const Rounded& a, const Rounded& b) {
    const double value = a.value * b.value;
    const double error =
        std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
    return {value, error + kUlp * (std::abs(value) + error)};
}
/// Division is promised to 2.5 units in the last place. A divisor that may be 0 leaves nothing
/// known.
inline Rounded operator/(const Rounded& a, const Rounded& b) {
    const double value = a.value / b.value;
    const double least = std::abs(b.value) - b.error;
    if (!(least > 0.0)) return {0.0, INFINITY};
    const double error = (a.error + std::abs(value) * b.error) / least;
    return {value, error + 2.5 * kUlp * (std::abs(value) + error)};
}

/// A value with whichever of two ends is farther.
[[nodiscard]] inline Rounded between(double value, double low, double high) {
    return {value, std::max(value - low, high - value)};
}
inline Rounded max(const Rounded& a, const Rounded& b) {
    return between(std::max(a.value, b.value), std::max(a.low(), b.low()),
                   std::max(a.high(), b.high()));
}
inline Rounded min(const Rounded& a, const Rounded& b) {
    return between(std::min(a.value, b.value), std::min(a.low(), b.low()),
                   std::min(a.high(), b.high()));
}
inline Rounded clamp(const Rounded& a, const Rounded& low, const Rounded& high) {
    return min(max(a, low), high);
}
inline Rounded abs(const Rounded& a) { return {std::abs(a.value), a.error}; }

/// 1 / sqrt(a), promised to 2 units in the last place.
inline Rounded inverse_sqrt(const Rounded& a) {
    const double value = 1.0 / std::sqrt(a.value);
    if (!(a.low() > 0.0)) return {value, INFINITY};
    const double error = 1.0 / std::sqrt(a.low()) - value;
    return {value, error + 2.0 * kUlp * (value + error)};
}

/// sqrt(a) of 0 <= a, promised as 1 / inversesqrt(a).
inline Rounded sqrt(const Rounded& a) {
    const double value = std::sqrt(std::max(a.value, 0.0));
    const double error = std::max(std::sqrt(std::max(a.high(), 0.0)) - value,
                                  value - std::sqrt(std::max(a.low(), 0.0)));
    return {value, error + 4.5 * kUlp * (value + error)};
}

/// a^power of 0 < a as exp2(power * log2(a)): log2 is promised to 2^-21 between 1/2 and 2 and to 3
/// units in the last place elsewhere, exp2(t) to 3 + 2 |t| of them.
inline Rounded pow(const Rounded& a, const Rounded& power) {
    const double value = std::pow(a.value, power.value);
    if (!(a.low() > 0.0)) return {value, INFINITY};
    const double log = std::log2(a.value);
    const bool near_one = a.low() >= 0.5 && a.high() <= 2.0;
    const double log_error = (std::log2(a.value) - std::log2(a.low())) +
                             (near_one ? 0x1p-21 : 3.0 * kUlp * std::abs(log));
    const Rounded exponent = power * Rounded(log, log_error);
    // A result below 2^-126 may be flushed to 0.
    const double error = value * std::expm1(exponent.error * std::log(2.0));
    return {value, error + (3.0 + 2.0 * exponent.size()) * kUlp * (value + error) + 0x1p-126};
}

// What single precision may find true: both, where the two lie within their errors or an error is
// not a number.
[[nodiscard]] inline bool may_be_less(const Rounded& a, const Rounded& b) {
    return !(a.value - b.value >= a.error + b.error);
}
[[nodiscard]] inline bool may_be_at_least(const Rounded& a, const Rounded& b) {
    return !(a.value - b.value < -(a.error + b.error));
}

/// Three of them, as a shader's vec3.
struct Rounded3 {
    Rounded x;
    Rounded y;
    Rounded z;
};
inline Rounded3 operator-(const Rounded3& a) { return {-a.x, -a.y, -a.z}; }
inline Rounded3 operator+(const Rounded3& a, const Rounded3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Rounded3 operator*(const Rounded3& a, const Rounded& b) {
    return {a.x * b, a.y * b, a.z * b};
}
inline Rounded dot(const Rounded3& a, const Rounded3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// GLSL's: a - 2 dot(n, a) n.
inline Rounded3 reflect(const Rounded3& a, const Rounded3& n) {
    return a + n * (Rounded(-2.0) * dot(n, a));
}

}  // namespace obscura::renderer
