// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace obscura::analysis {

/// A choice by its two prices; less is better in both.
struct CostAndError {
    double cost = 0.0;
    double error = 0.0;
};

/// Whether no other choice is at least as good in both prices and better in one.
[[nodiscard]] bool is_on_front(const CostAndError& choice, const std::vector<CostAndError>& others);

/// The choices on the front, by rising cost; of equal ones the first. A choice with a price that is
/// not a number is never on it.
[[nodiscard]] std::vector<CostAndError> pareto_front(const std::vector<CostAndError>& choices);

}  // namespace obscura::analysis
