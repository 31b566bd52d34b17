// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::stimuli {

/// What a hypothesis is about.
enum class HypothesisKind {
    kPreference,  ///< one image of its conditions, taken together, is preferred
    kInteraction  ///< the preference differs between the conditions of a pair
};
inline constexpr std::array kHypothesisKinds{HypothesisKind::kPreference,
                                             HypothesisKind::kInteraction};

/// Whether its tests are corrected together with the others.
enum class HypothesisRole { kPrimary, kSecondary };
inline constexpr std::array kHypothesisRoles{HypothesisRole::kPrimary, HypothesisRole::kSecondary};

/// `preference`, `interaction`, as in files.
[[nodiscard]] std::string_view to_string(HypothesisKind kind);
/// `primary`, `secondary`.
[[nodiscard]] std::string_view to_string(HypothesisRole role);

/// A question that a study fixes before it has data: a [[hypothesis]] of its file.
struct Hypothesis {
    std::string id;
    std::string statement;
    HypothesisKind kind = HypothesisKind::kPreference;
    std::vector<std::string> conditions;          ///< of a preference: those it pools
    std::vector<std::vector<std::string>> pairs;  ///< of an interaction: each is one test
    double margin = 0.15;  ///< of a share, 0.01 to 0.49: the smallest effect that matters
    HypothesisRole role = HypothesisRole::kPrimary;
    /// Of a preference: it claims that the more accurate image is preferred, so that b has to be
    /// the more accurate one in each of its conditions.
    bool accuracy = false;
};

}  // namespace obscura::stimuli
