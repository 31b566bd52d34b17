// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/random.h"
#include "stimuli/order/order.h"

namespace obscura::stimuli {

/// A random Latin square of that order, uniform over all of them: n rows of the symbols 0 .. n-1,
/// each once per row and once per column.
///
/// Jacobson and Matthews 1996, "Generating uniformly distributed random Latin squares": a Markov
/// chain over proper squares and squares with one cell out of balance, whose moves connect all of
/// them and which visits every proper square equally often. The square is the (n^2 + 16)-th proper
/// one, so that which one it is depends on visits alone, not on when a visit happened; then rows,
/// columns and symbols are permuted uniformly, which leaves the law as it is and makes every square
/// of the same shape exactly equally likely after any number of moves.
/// Throws bad input unless n is 1 to kMostConditions.
[[nodiscard]] Square random_latin_square(int n, base::Random& random);

/// Every row and every column holds 0 .. n-1 once.
[[nodiscard]] bool is_latin(const Square& square);

}  // namespace obscura::stimuli
