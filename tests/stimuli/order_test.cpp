// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/order/order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <map>
#include <numeric>
#include <set>

#include "renderer/base/error.h"
#include "stimuli/order/latin_square.h"
#include "stimuli/order/williams.h"

namespace obscura::stimuli {
namespace {

std::map<Square, int> draw_squares(int n, int draws, std::uint64_t seed) {
    base::Random random(seed);
    std::map<Square, int> counts;
    for (int i = 0; i < draws; ++i) ++counts[random_latin_square(n, random)];
    return counts;
}

/// p-value of the hypothesis that all `cells` are equally likely.
double uniformity_p(const std::map<Square, int>& counts, int cells, int draws) {
    const double expected = static_cast<double>(draws) / cells;
    double chi_square = (cells - static_cast<double>(counts.size())) * expected;
    for (const auto& [square, count] : counts) {
        chi_square += (count - expected) * (count - expected) / expected;
    }
    return boost::math::cdf(
        boost::math::complement(boost::math::chi_squared(cells - 1), chi_square));
}

std::vector<std::vector<int>> rows_of(const std::vector<SessionOrder>& orders, std::size_t first,
                                      std::size_t count) {
    std::vector<std::vector<int>> rows;
    for (std::size_t i = first; i < first + count; ++i) rows.push_back(orders[i].conditions);
    return rows;
}

/// All that differ from the diagonal are the same number; it is returned, or -1.
long long neighbour_constant(const NeighbourCounts& counts) {
    const std::size_t n = counts.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            if (counts[i][j] != (i == j ? 0 : counts[0][1])) return -1;
        }
    }
    return counts[0][1];
}

TEST(LatinSquare, EveryDrawIsLatinAtEveryOrder) {
    base::Random random(11);
    for (int n = 1; n <= 16; ++n) {
        for (int i = 0; i < 20; ++i) EXPECT_TRUE(is_latin(random_latin_square(n, random))) << n;
    }
    EXPECT_TRUE(is_latin(random_latin_square(kMostConditions, random)));
}

TEST(LatinSquare, TheCheckOfASquareSeesWhatIsWrong) {
    EXPECT_TRUE(is_latin({{0, 1}, {1, 0}}));
    EXPECT_FALSE(is_latin({{0, 1}, {0, 1}}));        // columns repeat
    EXPECT_FALSE(is_latin({{0, 0}, {1, 1}}));        // rows repeat
    EXPECT_FALSE(is_latin({{1, 2}, {2, 1}}));        // other symbols
    EXPECT_FALSE(is_latin({{0, 1, 0}, {1, 0, 1}}));  // not square
}

TEST(LatinSquare, AllTwoSquaresOfOrder2AndTwelveOfOrder3AreReachedEvenly) {
    const auto two = draw_squares(2, 2000, 1);
    EXPECT_EQ(two.size(), 2U);
    EXPECT_GT(uniformity_p(two, 2, 2000), 1e-3);
    const auto three = draw_squares(3, 12000, 2);
    EXPECT_EQ(three.size(), 12U);
    EXPECT_GT(uniformity_p(three, 12, 12000), 1e-3);
}

TEST(LatinSquare, The576SquaresOfOrder4AreEquallyLikelyOver57600Draws) {
    const auto counts = draw_squares(4, 57600, 3);
    EXPECT_EQ(counts.size(), 576U);
    EXPECT_GT(uniformity_p(counts, 576, 57600), 1e-3);
}

/// 2 x 2 sub-squares; permuting rows, columns or symbols does not change their number.
int count_intercalates(const Square& square) {
    const std::size_t n = square.size();
    int count = 0;
    for (std::size_t r = 0; r < n; ++r) {
        for (std::size_t q = r + 1; q < n; ++q) {
            for (std::size_t c = 0; c < n; ++c) {
                for (std::size_t d = c + 1; d < n; ++d) {
                    count += square[r][c] == square[q][d] && square[r][d] == square[q][c] ? 1 : 0;
                }
            }
        }
    }
    return count;
}

/// z of the share of squares with that many sub-squares among the draws.
double z_of_share(int n, int intercalates, double share, int draws, std::uint64_t seed) {
    int met = 0;
    for (const auto& [square, count] : draw_squares(n, draws, seed)) {
        met += count_intercalates(square) == intercalates ? count : 0;
    }
    return (met - draws * share) / std::sqrt(draws * share * (1.0 - share));
}

/// Squares of orders 4 and 5 come in two shapes that permuting rows, columns and symbols cannot
/// turn into each other, so that only the chain can bring their shares about; one degree of freedom
/// sees a shift that 575 hide. Order 4: the Klein group's, 12 sub-squares, 144 of 576. Order 5: the
/// cyclic group's, none, (5!)^3 / (5^2 * 4) = 17280 of 161280 (orbit and stabiliser).
TEST(LatinSquare, TheShapesOfOrders4And5HaveTheSharesThatCountingGives) {
    EXPECT_LT(std::abs(z_of_share(4, 12, 144.0 / 576.0, 10000, 4)), 3.29);  // two-sided p of 1e-3
    EXPECT_LT(std::abs(z_of_share(5, 0, 17280.0 / 161280.0, 10000, 5)), 3.29);
}

TEST(LatinSquare, AnOrderThatIsOutOfRangeIsRefused) {
    base::Random random(1);
    for (const int n : {-1, 0, kMostConditions + 1}) {
        EXPECT_THROW((void)random_latin_square(n, random), base::Error) << n;
        EXPECT_THROW((void)williams_squares(n), base::Error) << n;
    }
}

TEST(Williams, TheFirstRowRunsFromBothEnds) {
    EXPECT_EQ(williams_squares(6)[0][0], (std::vector<int>{0, 1, 5, 2, 4, 3}));
    EXPECT_EQ(williams_squares(7)[0][0], (std::vector<int>{0, 1, 6, 2, 5, 3, 4}));
}

TEST(Williams, EveryConditionFollowsEveryOtherEquallyOftenAndNeverItself) {
    for (int n = 2; n <= 12; ++n) {
        const std::vector<Square> squares = williams_squares(n);
        ASSERT_EQ(squares.size(), n % 2 == 0 ? 1U : 2U);
        std::vector<std::vector<int>> rows;
        for (const Square& square : squares) {
            EXPECT_TRUE(is_latin(square)) << n;
            rows.insert(rows.end(), square.begin(), square.end());
        }
        EXPECT_EQ(neighbour_constant(count_neighbours(rows, n)), n % 2 == 0 ? 1 : 2) << n;
    }
}

TEST(Order, ABlockOfTheThesisIsOneSquareItsSwapAndThenANewSquare) {
    const auto orders = session_orders(OrderKind::kLatinSquare, 7, 20100501, 28);
    const auto first = rows_of(orders, 0, 7);
    EXPECT_TRUE(is_latin(first));
    EXPECT_EQ(rows_of(orders, 7, 7), first);
    EXPECT_TRUE(is_latin(rows_of(orders, 14, 7)));
    EXPECT_NE(rows_of(orders, 14, 7), first);
    for (const SessionOrder& order : orders) {
        EXPECT_EQ(order.latin_square, order.slot / 14);
        EXPECT_EQ(order.latin_row, static_cast<int>(order.slot % 7));
        EXPECT_EQ(order.swapped, order.slot % 14 >= 7);
    }
}

TEST(Order, OneSlotAloneIsTheSameAsInTheWholePlan) {
    for (const OrderKind kind : kOrderKinds) {
        for (const int n : {1, 2, 6, 7}) {
            const auto orders = session_orders(kind, n, 5, 40);
            for (const std::uint64_t slot : {39U, 0U, 13U, 14U}) {
                const SessionOrder alone = session_order(kind, n, 5, slot);
                EXPECT_EQ(alone.conditions, orders[slot].conditions);
                EXPECT_EQ(alone.swapped, orders[slot].swapped);
                EXPECT_EQ(alone.latin_square, orders[slot].latin_square);
                EXPECT_EQ(alone.latin_row, orders[slot].latin_row);
            }
        }
    }
}

TEST(Order, AnotherSeedGivesAnotherOrderUnlessItIsFixed) {
    for (const OrderKind kind :
         {OrderKind::kLatinSquare, OrderKind::kWilliams, OrderKind::kRandom}) {
        const auto one = session_orders(kind, 7, 1, 14);
        const auto two = session_orders(kind, 7, 2, 14);
        EXPECT_NE(rows_of(one, 0, 14), rows_of(two, 0, 14)) << to_string(kind);
    }
    const auto fixed = session_orders(OrderKind::kFixed, 3, 1, 2);
    EXPECT_EQ(fixed[0].conditions, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(fixed[1].conditions, fixed[0].conditions);
    EXPECT_FALSE(fixed[0].swapped);
    EXPECT_TRUE(fixed[1].swapped);
}

TEST(Order, SquaresOfOneStudyAreUnrelatedToTheNextSeeds) {
    // Were square i of seed s the square i - 1 of seed s + 1, studies would share their squares.
    for (std::uint64_t i = 1; i < 20; ++i) {
        EXPECT_NE(session_order(OrderKind::kLatinSquare, 7, 1, 14 * i).conditions,
                  session_order(OrderKind::kLatinSquare, 7, 2, 14 * (i - 1)).conditions);
    }
}

TEST(Order, AWilliamsBlockBalancesNeighboursPositionsAndSides) {
    for (const int n : {2, 4, 5, 6, 7}) {
        const std::uint64_t block = block_size(OrderKind::kWilliams, n);
        ASSERT_EQ(block, 2U * n);
        const auto orders = session_orders(OrderKind::kWilliams, n, 9, 4 * block);
        for (std::uint64_t start = 0; start < 4 * block; start += block) {
            const auto rows = rows_of(orders, start, block);
            EXPECT_EQ(neighbour_constant(count_neighbours(rows, n)), 2) << n;
            EXPECT_TRUE(is_latin(rows_of(orders, start, n)));
            EXPECT_TRUE(is_latin(rows_of(orders, start + n, n)));
            const auto swapped =
                std::count_if(orders.begin() + start, orders.begin() + start + block,
                              [](const auto& order) { return order.swapped; });
            EXPECT_EQ(swapped, n);
        }
    }
}

TEST(Order, TwoWilliamsBlocksOfOddOrderBalanceNeighboursOnEachSideToo) {
    const auto orders = session_orders(OrderKind::kWilliams, 7, 9, 28);
    for (const bool side : {false, true}) {
        std::vector<std::vector<int>> rows;
        for (const SessionOrder& order : orders) {
            if (order.swapped == side) rows.push_back(order.conditions);
        }
        EXPECT_EQ(neighbour_constant(count_neighbours(rows, 7)), 2);
    }
}

TEST(Order, ARandomOrderIsAPermutationAndHalfOfABlockIsSwapped) {
    const auto orders = session_orders(OrderKind::kRandom, 7, 9, 140);
    std::set<std::vector<int>> different;
    for (const SessionOrder& order : orders) {
        std::vector<int> sorted = order.conditions;
        std::sort(sorted.begin(), sorted.end());
        std::vector<int> all(7);
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(sorted, all);
        EXPECT_EQ(order.swapped, order.slot % 14 >= 7);
        different.insert(order.conditions);
    }
    EXPECT_GT(different.size(), 130U);  // of 5040
}

TEST(Order, ACountThatIsOutOfRangeIsRefused) {
    for (const OrderKind kind : kOrderKinds) {
        for (const int n : {-3, 0, kMostConditions + 1}) {
            EXPECT_THROW((void)session_order(kind, n, 1, 0), base::Error);
            EXPECT_THROW((void)block_size(kind, n), base::Error);
        }
    }
}

TEST(Order, TheLastSlotThatThereIsHasAnOrderToo) {
    for (const OrderKind kind : kOrderKinds) {
        EXPECT_EQ(session_order(kind, 7, UINT64_MAX, UINT64_MAX).conditions.size(), 7U);
    }
}

TEST(Order, NamesAndKindsGoBothWays) {
    for (const OrderKind kind : kOrderKinds) EXPECT_EQ(order_kind_from(to_string(kind)), kind);
    EXPECT_EQ(order_kind_from("latin_square"), std::nullopt);
}

TEST(Slots, ASessionThatWasBrokenOffGivesItsRowToTheNextParticipant) {
    EXPECT_EQ(next_slot({}), 0U);
    EXPECT_EQ(next_slot({0, 1, 2}), 3U);
    EXPECT_EQ(next_slot({0, 2, 3}), 1U);
    EXPECT_EQ(next_slot({3, 1, 0}), 2U);
    EXPECT_EQ(next_slot({1, 2}), 0U);
    EXPECT_EQ(next_slot({0, 0, 1}), 2U);
}

}  // namespace
}  // namespace obscura::stimuli
