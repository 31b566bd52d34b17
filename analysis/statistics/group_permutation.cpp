// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/group_permutation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "analysis/statistics/chi_square.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

/// The most additions of an exact test.
constexpr double kMostTaken = 2e7;

/// share[k][s]: of all ways to take k of the numbers seen so far, those with sum s, as parts of all
/// ways to take any. Kept as chances: each number is taken or not with equal chance.
class Sums {
  public:
    Sums(std::size_t most, std::int64_t total)
        : width_(static_cast<std::size_t>(total) + 1), chance_((most + 1) * width_) {
        chance_[0] = 1.0;
    }
    void add(std::int64_t number) {
        const auto step = static_cast<std::size_t>(number);
        const std::size_t rows = chance_.size() / width_;
        ++numbers_;
        total_ += step;
        for (std::size_t k = std::min(rows, numbers_ + 1); k-- > 0;) {
            double* const row = chance_.data() + k * width_;
            for (std::size_t s = total_ + 1; s-- > 0;) {
                double chance = row[s] / 2.0;
                if (k > 0 && s >= step) chance += (row - width_)[s - step] / 2.0;
                row[s] = chance;
            }
        }
    }
    [[nodiscard]] const double* of(std::size_t taken) const {
        return chance_.data() + taken * width_;
    }

  private:
    std::size_t width_;
    std::vector<double> chance_;
    std::size_t numbers_ = 0;  ///< seen so far
    std::size_t total_ = 0;    ///< their sum
};

/// How far a sum of the first group is from what is expected, in units that are whole numbers.
std::int64_t distance(std::int64_t sum, std::int64_t total, std::size_t taken, std::size_t n) {
    return std::abs(sum * static_cast<std::int64_t>(n) - total * static_cast<std::int64_t>(taken));
}

}  // namespace

Possible<GroupPermutation> group_permutation(const std::vector<std::int64_t>& one,
                                             const std::vector<std::int64_t>& other) {
    using None = Possible<GroupPermutation>;
    constexpr std::int64_t kMost = 1'000'000;
    if (one.empty() || other.empty()) return None::none("one of the groups is empty");
    // The smaller group is summed; the other's sum is what it leaves.
    const std::vector<std::int64_t>& first = one.size() <= other.size() ? one : other;
    std::vector<std::int64_t> all = one;
    all.insert(all.end(), other.begin(), other.end());
    std::int64_t total = 0;
    std::int64_t sum = 0;
    for (const std::int64_t number : all) {
        base::check_range("group_permutation", "number", number, std::int64_t{0}, kMost);
        total += number;
    }
    for (const std::int64_t number : first) sum += number;
    const auto [low, high] = std::minmax_element(all.begin(), all.end());
    if (*low == *high) return None::none("all participants gave the same");
    const std::size_t n = all.size();
    const std::int64_t reached = distance(sum, total, first.size(), n);
    GroupPermutation test;
    test.is_exact = static_cast<double>(n) * static_cast<double>(first.size() + 1) *
                        static_cast<double>(total + 1) <=
                    kMostTaken;
    if (!test.is_exact) {
        const auto size = static_cast<double>(n);
        const auto taken = static_cast<double>(first.size());
        const double mean = static_cast<double>(total) / size;
        double squares = 0.0;
        for (const std::int64_t number : all) {
            const double off = static_cast<double>(number) - mean;
            squares += off * off;
        }
        // The variance of the sum of so many drawn without putting back.
        const double variance = taken * (size - taken) / (size * (size - 1.0)) * squares;
        const double off = static_cast<double>(sum) - taken * mean;
        test.p = chi_square_tail(off * off / variance, 1);
        return test;
    }
    Sums sums(first.size(), total);
    for (const std::int64_t number : all) sums.add(number);
    const double* const chance = sums.of(first.size());
    double every = 0.0;
    double tail = 0.0;
    for (std::int64_t value = 0; value <= total; ++value) {
        const double own = chance[static_cast<std::size_t>(value)];
        every += own;
        if (distance(value, total, first.size(), n) >= reached) tail += own;
    }
    test.p.p = std::min(1.0, tail / every);
    test.p.log10_p = std::log10(test.p.p);
    return test;
}

}  // namespace obscura::analysis
