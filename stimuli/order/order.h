// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace obscura::stimuli {

/// How conditions are ordered over participants.
enum class OrderKind {
    kLatinSquare,  ///< a random Latin square, as in the thesis
    kWilliams,     ///< balanced for first-order carry-over
    kRandom,       ///< a random permutation for each participant
    kFixed,        ///< the order of the study file
};

inline constexpr std::array kOrderKinds{OrderKind::kLatinSquare, OrderKind::kWilliams,
                                        OrderKind::kRandom, OrderKind::kFixed};

/// `latin-square`, `williams`, `random`, `fixed`, as in files.
[[nodiscard]] std::string_view to_string(OrderKind kind);
[[nodiscard]] std::optional<OrderKind> order_kind_from(std::string_view name);

/// Over what the two images of the pairs change places.
enum class SideOrder {
    kSession,  ///< all pairs of a session alike, as in the thesis
    kTrial,    ///< from one condition to the next, so that each session holds both
};

inline constexpr std::array kSideOrders{SideOrder::kSession, SideOrder::kTrial};

/// `session`, `trial`, as in files.
[[nodiscard]] std::string_view to_string(SideOrder sides);
[[nodiscard]] std::optional<SideOrder> side_order_from(std::string_view name);

/// The most conditions that an order is made for.
inline constexpr int kMostConditions = 64;

/// Rows of condition indices 0 .. n-1.
using Square = std::vector<std::vector<int>>;

/// What one participant sees.
struct SessionOrder {
    std::uint64_t slot = 0;          ///< which completed session this is, from 0
    std::uint64_t latin_square = 0;  ///< which square, from 0
    int latin_row = 0;               ///< row of that square, from 0
    /// B is shown first: in every pair, or with SideOrder::kTrial in those whose condition has an
    /// even index, and A in the others.
    bool swapped = false;
    std::vector<int> conditions;  ///< indices into the study's conditions, in order of showing
    SideOrder sides = SideOrder::kSession;

    /// Whether B is the first image of the trial at that position.
    [[nodiscard]] bool b_first(std::size_t position) const {
        const bool is_turned = sides == SideOrder::kTrial && conditions.at(position) % 2 != 0;
        return swapped != is_turned;
    }
};

/// The order for a slot. The same kind, count, seed and slot give the same order everywhere.
///
/// latin-square: square slot / 2n, row slot % n, swapped in the second n slots of a square (the
/// thesis, 5.5). williams, even n: the same with a Williams design; odd n: two squares of n rows
/// make a block, one of them swapped, in the next block the other one, so that 4n slots balance
/// the neighbours within each side too. random: slots count as for latin-square, each with its own
/// permutation. fixed: the order of the file, every second slot swapped.
///
/// With SideOrder::kTrial image A is first where slot / n + index of the condition is even
/// (Williams and fixed: with their own swapped in place of slot / n), so that in each session each
/// side is first in half of the pairs, one more or less where they are odd, and over a block still
/// each image of a condition equally often. Throws bad input unless condition_count is 1 to
/// kMostConditions.
[[nodiscard]] SessionOrder session_order(OrderKind kind, int condition_count, std::uint64_t seed,
                                         std::uint64_t slot, SideOrder sides = SideOrder::kSession);

/// session_order of the slots 0 .. slot_count - 1; each square is drawn once.
[[nodiscard]] std::vector<SessionOrder> session_orders(OrderKind kind, int condition_count,
                                                       std::uint64_t seed, std::uint64_t slot_count,
                                                       SideOrder sides = SideOrder::kSession);

/// How many slots make a block in which all that the order promises balances: 2n, for fixed 2.
[[nodiscard]] std::uint64_t block_size(OrderKind kind, int condition_count);

/// The smallest slot that is not among those taken; a session broken off takes none.
[[nodiscard]] std::uint64_t next_slot(const std::vector<std::uint64_t>& taken);

}  // namespace obscura::stimuli
