// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/pareto.h"

#include <algorithm>
#include <cmath>

namespace obscura::analysis {

bool is_on_front(const CostAndError& choice, const std::vector<CostAndError>& others) {
    if (std::isnan(choice.cost) || std::isnan(choice.error)) return false;
    return std::none_of(others.begin(), others.end(), [&choice](const CostAndError& other) {
        return other.cost <= choice.cost && other.error <= choice.error &&
               (other.cost < choice.cost || other.error < choice.error);
    });
}

std::vector<CostAndError> pareto_front(const std::vector<CostAndError>& choices) {
    std::vector<CostAndError> sorted;
    for (const CostAndError& choice : choices) {
        if (!std::isnan(choice.cost) && !std::isnan(choice.error)) sorted.push_back(choice);
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
    });
    std::vector<CostAndError> front;
    for (const CostAndError& choice : sorted) {
        if (front.empty() || choice.error < front.back().error) front.push_back(choice);
    }
    return front;
}

}  // namespace obscura::analysis
