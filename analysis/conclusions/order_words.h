// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// What one side for all pairs of a session costs: how often a true share of kRelevantShare is
/// found at kSignificance, taken for itself, in simulated studies.
struct SideCost {
    std::int64_t participants = 0;
    std::size_t conditions = 0;  ///< pooled
    double second = 0.5;         ///< share of the second of two alike images
    double constant = 0.0;       ///< power with one side a session
    double varied = 0.0;         ///< with sides that change within it
};

/// Participants beyond which nothing is simulated.
inline constexpr std::int64_t kMostCosted = 300;

/// Of kSideStudies studies each, whose observers differ by a standard deviation of 1 in log odds;
/// the same for the same arguments.
[[nodiscard]] SideCost side_cost(std::int64_t participants, std::size_t conditions, double second);
inline constexpr int kSideStudies = 1000;

/// Whether the order of showing mattered, with the test over participants and its interval; where
/// each saw one side throughout, what that costs a study like this one. Needs the order to be
/// known.
[[nodiscard]] std::string order_words(const Analysis& analysis);

}  // namespace obscura::analysis
