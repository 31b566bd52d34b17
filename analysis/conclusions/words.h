// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// A p-value as journals print it (APA 7, 6.36), without its name: three decimals and no zero
/// before the point, `.031`; `< .001`, `> .999`.
[[nodiscard]] std::string p_number(const PValue& p);
[[nodiscard]] std::string p_number(const Possible<double>& p);  ///< `none` where there is none
/// With its name: `p = .031`, `p < .001`.
[[nodiscard]] std::string p_words(const PValue& p);

/// A p-value to be copied from a table: six decimals, four significant digits below a thousandth,
/// and a power of ten where a double is too small.
[[nodiscard]] std::string p_text(const PValue& p);

/// `15 points`
[[nodiscard]] std::string points_words(double margin);
/// A share, 0 to 1, in per cent: `69 %`; with `decimals` behind the point.
[[nodiscard]] std::string percent(double share, int decimals = 0);
/// `53 to 82 %`
[[nodiscard]] std::string percent(const Interval& interval);

/// `1 participant`, `36 participants`.
[[nodiscard]] std::string counted(std::int64_t n, std::string_view singular,
                                  std::string_view plural = "");

/// Words joined as in a sentence: `a`, `a and b`, `a, b and c`; `none` for no word.
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

/// With a capital letter at its beginning.
[[nodiscard]] std::string capital(std::string text);

/// `None against Blizzard24 in atrium over moderate, high (II, V)`
[[nodiscard]] std::string what_is_compared(const Comparison& comparison);

/// `I, IV and VII have no partner at another level in the same scene.`
[[nodiscard]] std::string partner_words(const std::vector<std::string>& without_partner);

/// What the scale's standard errors rest on, its order term and its prior, where it has them.
[[nodiscard]] std::string scale_words(const VariantScale& scale);

/// `simulated observer` for simulated data, `participant` otherwise; a number brings the plural.
[[nodiscard]] std::string who(const Tally& tally, std::int64_t n);

/// The number of a level of validity among low, moderate, high, and 3 for any other.
[[nodiscard]] std::size_t level_number(std::string_view validity);

}  // namespace obscura::analysis
