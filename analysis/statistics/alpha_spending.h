// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace obscura::analysis {

/// How much of the level may be used up by the time that a share of the participants has come
/// (K. K. G. Lan and D. L. DeMets 1983).
enum class Spending {
    kNone,           ///< one look, which has all of it
    kObrienFleming,  ///< 4 (1 - normal(z of level / 4, over the square root of the share))
    kPocock          ///< level ln(1 + (e - 1) share)
};
inline constexpr std::array kSpendings{Spending::kNone, Spending::kObrienFleming,
                                       Spending::kPocock};

/// `none`, `obrien-fleming`, `pocock`, as in files.
[[nodiscard]] std::string_view to_string(Spending spending);
[[nodiscard]] std::optional<Spending> spending_from(std::string_view name);

/// The most looks that boundaries are computed for.
inline constexpr std::size_t kMostLooks = 50;

/// What counts at one look, two-sided.
struct LookBoundary {
    double spent = 0.0;  ///< of the level, by this look
    double z = 0.0;      ///< the smallest |z| that counts
    double p = 0.0;      ///< the largest p that counts
};

/// The boundaries of looks with so many participants each, rising, at most kMostLooks, of `planned`
/// at the last one; all of the level is spent once those have come. By integrating over the paths
/// that went on (P. Armitage, C. K. McPherson and B. C. Rowe 1969). `level` is more than 0 and less
/// than 1.
[[nodiscard]] std::vector<LookBoundary> look_boundaries(Spending spending, double level,
                                                        const std::vector<std::int64_t>& looks,
                                                        std::int64_t planned);

/// The smallest level at which a p-value at the last of those looks counts: what stands in its
/// place where looks are spent for (Q. Liu and K. M. Anderson 2008). Never below p, at most 1.
[[nodiscard]] double p_after_spending(double p, Spending spending,
                                      const std::vector<std::int64_t>& looks, std::int64_t planned);

/// How often a test at that level finds something at one of the looks where nothing is, without a
/// correction for looking, in large samples.
[[nodiscard]] double repeated_look_error(double level, const std::vector<std::int64_t>& looks);

}  // namespace obscura::analysis
