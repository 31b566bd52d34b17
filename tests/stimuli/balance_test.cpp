// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/order/balance.h"

#include <gtest/gtest.h>

namespace obscura::stimuli {
namespace {

Balance balance_of_kind(OrderKind kind, int n, std::uint64_t sessions) {
    return balance_of(session_orders(kind, n, 20100501, sessions), n);
}

SessionOrder session(std::vector<int> conditions, bool swapped) {
    SessionOrder order;
    order.conditions = std::move(conditions);
    order.swapped = swapped;
    return order;
}

TEST(Balance, CountsWhatIsThere) {
    const Balance balance = balance_of({session({0, 1, 2}, false), session({0, 2, 1}, true)}, 3);
    EXPECT_EQ(balance.at_position, (NeighbourCounts{{2, 0, 0}, {0, 1, 1}, {0, 1, 1}}));
    EXPECT_EQ(balance.neighbours, (NeighbourCounts{{0, 1, 1}, {0, 0, 1}, {0, 1, 0}}));
    EXPECT_EQ(balance.a_first, (std::vector<long long>{1, 1, 1}));
    EXPECT_EQ(balance.b_first, (std::vector<long long>{1, 1, 1}));
    EXPECT_TRUE(balance.rows_hold());
    EXPECT_TRUE(balance.sides_hold());
    EXPECT_FALSE(balance.columns_hold());  // no square is whole
    EXPECT_FALSE(balance.neighbours_hold());
}

TEST(Balance, SeesAConditionThatIsShownTwice) {
    const Balance balance = balance_of({session({0, 0}, false), session({1, 1}, true)}, 2);
    EXPECT_EQ(balance.complete_rows, 0U);
    EXPECT_FALSE(balance.rows_hold());
    EXPECT_EQ(balance.latin_squares, 0U);
    EXPECT_FALSE(balance.columns_hold());
}

TEST(Balance, SidesOfATrialHoldInEverySessionAndOverABlockOfAnyOrder) {
    for (const OrderKind kind : kOrderKinds) {
        for (int n = 2; n <= 9; ++n) {
            const auto block = block_size(kind, n);
            const Balance balance =
                balance_of(session_orders(kind, n, 20100501, 3 * block, SideOrder::kTrial), n);
            EXPECT_TRUE(balance.sides_hold()) << to_string(kind) << n;
            EXPECT_TRUE(balance.sides_hold_in_sessions()) << to_string(kind) << n;
            EXPECT_FALSE(balance_of_kind(kind, n, block).sides_hold_in_sessions())
                << to_string(kind) << n << ": not where a session has one side";
        }
    }
}

TEST(Balance, OfATrialHasAFirstWhereTheSlotsRoundAndTheConditionsIndexAreEvenTogether) {
    const auto orders = session_orders(OrderKind::kLatinSquare, 7, 20100501, 28, SideOrder::kTrial);
    for (const SessionOrder& order : orders) {
        for (std::size_t i = 0; i < order.conditions.size(); ++i) {
            const auto condition = static_cast<std::uint64_t>(order.conditions[i]);
            EXPECT_EQ(order.b_first(i), (order.slot / 7 + condition) % 2 == 1);
        }
    }
}

TEST(Balance, AWholeBlockOfTheThesisHoldsAllButCarryOver) {
    const Balance balance = balance_of_kind(OrderKind::kLatinSquare, 7, 28);
    EXPECT_TRUE(balance.rows_hold());
    EXPECT_TRUE(balance.columns_hold());
    EXPECT_TRUE(balance.sides_hold());
    EXPECT_EQ(balance.squares, 4U);
    EXPECT_EQ(balance.a_first.front(), 14);
}

TEST(Balance, The36ParticipantsOfTheThesisLeaveASquareUnfinished) {
    const Balance balance = balance_of_kind(OrderKind::kLatinSquare, 7, 36);
    EXPECT_TRUE(balance.rows_hold());
    EXPECT_FALSE(balance.columns_hold());
    EXPECT_EQ(balance.latin_squares, 5U);
    EXPECT_FALSE(balance.sides_hold());
    EXPECT_EQ(balance.a_first.front(), 21);
    EXPECT_EQ(balance.b_first.front(), 15);
}

TEST(Balance, AWilliamsBlockHoldsEverything) {
    for (const int n : {1, 2, 6, 7}) {
        const Balance balance =
            balance_of_kind(OrderKind::kWilliams, n, block_size(OrderKind::kWilliams, n));
        EXPECT_TRUE(balance.rows_hold() && balance.columns_hold() && balance.sides_hold() &&
                    balance.neighbours_hold())
            << n;
    }
}

TEST(Balance, AFixedOrderHoldsRowsAndSidesOnly) {
    const Balance balance = balance_of_kind(OrderKind::kFixed, 3, 6);
    EXPECT_TRUE(balance.rows_hold());
    EXPECT_TRUE(balance.sides_hold());
    EXPECT_FALSE(balance.columns_hold());
    EXPECT_FALSE(balance.neighbours_hold());
}

}  // namespace
}  // namespace obscura::stimuli
