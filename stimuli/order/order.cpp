// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/order/order.h"

#include <algorithm>
#include <numeric>

#include "renderer/base/check.h"
#include "stimuli/order/latin_square.h"
#include "stimuli/order/williams.h"

namespace obscura::stimuli {
namespace {

/// The index-th stream of a seed. A number drawn from the seed stands in its place, so that seeds 1
/// and 2 do not share all streams but one.
base::Random stream(std::uint64_t seed, std::uint64_t index) {
    base::Random of_seed(seed);
    return base::Random(of_seed.bits() + index);
}

std::vector<int> identity(int n) {
    std::vector<int> values(n);
    std::iota(values.begin(), values.end(), 0);
    return values;
}

/// Where a slot lies: everything but the order of its conditions.
SessionOrder place_of(OrderKind kind, int condition_count, std::uint64_t slot) {
    const auto n = static_cast<std::uint64_t>(condition_count);
    SessionOrder order;
    order.slot = slot;
    if (kind == OrderKind::kFixed) {
        order.latin_square = slot / 2;
        order.swapped = slot % 2 == 1;
        return order;
    }
    const bool second_half = slot / n % 2 == 1;
    order.latin_row = static_cast<int>(slot % n);
    if (kind == OrderKind::kWilliams && n % 2 == 1 && n > 1) {
        const bool second_block = slot / (2 * n) % 2 == 1;
        order.latin_square = slot / n;
        order.swapped = second_half != second_block;
    } else {
        order.latin_square = slot / (2 * n);
        order.swapped = second_half;
    }
    return order;
}

/// The Williams design with the conditions on its symbols by chance; drawn anew after all that a
/// design balances: two squares and both ways round.
std::vector<int> williams_row(int n, std::uint64_t seed, const SessionOrder& place) {
    const std::vector<Square> squares = williams_squares(n);
    const std::uint64_t squares_a_draw = squares.size() == 2 ? 4 : 1;
    base::Random random = stream(seed, place.latin_square / squares_a_draw);
    std::vector<int> label = identity(n);
    random.shuffle(label);
    std::vector<int> row = squares[place.latin_square % squares.size()][place.latin_row];
    for (int& condition : row) condition = label[condition];
    return row;
}

/// Draws the squares of one study, each once as long as slots are asked for in order.
class Scheduler {
  public:
    Scheduler(OrderKind kind, int condition_count, std::uint64_t seed)
        : kind_(kind), n_(condition_count), seed_(seed) {
        base::check_range("order", "number of conditions", condition_count, 1, kMostConditions);
    }

    [[nodiscard]] SessionOrder at(std::uint64_t slot) {
        SessionOrder order = place_of(kind_, n_, slot);
        switch (kind_) {
            case OrderKind::kLatinSquare:
                order.conditions = latin_square(order.latin_square)[order.latin_row];
                break;
            case OrderKind::kWilliams:
                order.conditions = williams_row(n_, seed_, order);
                break;
            case OrderKind::kRandom: {
                order.conditions = identity(n_);
                base::Random random = stream(seed_, slot);
                random.shuffle(order.conditions);
                break;
            }
            case OrderKind::kFixed:
                order.conditions = identity(n_);
                break;
        }
        return order;
    }

  private:
    const Square& latin_square(std::uint64_t index) {
        if (square_.empty() || index != square_index_) {
            base::Random random = stream(seed_, index);
            square_ = random_latin_square(n_, random);
            square_index_ = index;
        }
        return square_;
    }

    OrderKind kind_;
    int n_;
    std::uint64_t seed_;
    Square square_;
    std::uint64_t square_index_ = 0;
};

}  // namespace

std::string_view to_string(OrderKind kind) {
    switch (kind) {
        case OrderKind::kLatinSquare:
            return "latin-square";
        case OrderKind::kWilliams:
            return "williams";
        case OrderKind::kRandom:
            return "random";
        case OrderKind::kFixed:
            return "fixed";
    }
    return "";
}

std::optional<OrderKind> order_kind_from(std::string_view name) {
    for (const OrderKind kind : kOrderKinds) {
        if (to_string(kind) == name) return kind;
    }
    return std::nullopt;
}

std::string_view to_string(SideOrder sides) {
    return sides == SideOrder::kTrial ? "trial" : "session";
}

std::optional<SideOrder> side_order_from(std::string_view name) {
    for (const SideOrder sides : kSideOrders) {
        if (to_string(sides) == name) return sides;
    }
    return std::nullopt;
}

SessionOrder session_order(OrderKind kind, int condition_count, std::uint64_t seed,
                           std::uint64_t slot, SideOrder sides) {
    SessionOrder order = Scheduler(kind, condition_count, seed).at(slot);
    order.sides = sides;
    return order;
}

std::vector<SessionOrder> session_orders(OrderKind kind, int condition_count, std::uint64_t seed,
                                         std::uint64_t slot_count, SideOrder sides) {
    Scheduler scheduler(kind, condition_count, seed);
    std::vector<SessionOrder> orders;
    orders.reserve(slot_count);
    for (std::uint64_t slot = 0; slot < slot_count; ++slot) {
        orders.push_back(scheduler.at(slot));
        orders.back().sides = sides;
    }
    return orders;
}

std::uint64_t block_size(OrderKind kind, int condition_count) {
    base::check_range("order", "number of conditions", condition_count, 1, kMostConditions);
    return kind == OrderKind::kFixed ? 2 : 2 * static_cast<std::uint64_t>(condition_count);
}

std::uint64_t next_slot(const std::vector<std::uint64_t>& taken) {
    std::vector<std::uint64_t> sorted = taken;
    std::sort(sorted.begin(), sorted.end());
    std::uint64_t slot = 0;
    for (const std::uint64_t used : sorted) {
        if (used > slot) break;
        slot = used + 1;
    }
    return slot;
}

}  // namespace obscura::stimuli
