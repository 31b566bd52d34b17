// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/alpha_spending.h"

namespace obscura::analysis {

/// A question that a study fixes before it has data.
struct PlannedHypothesis {
    std::string id;
    std::string statement = {};                ///< a sentence; may be empty
    bool is_interaction = false;               ///< does the preference differ between conditions?
    std::vector<std::string> conditions = {};  ///< of a preference: those it pools
    std::vector<std::vector<std::string>> pairs = {};  ///< of an interaction: each is one test
    double margin = 0.15;    ///< of a share: the smallest effect that matters
    bool is_primary = true;  ///< its tests are corrected together

    bool operator==(const PlannedHypothesis&) const = default;
};

/// When a study looks at its answers.
struct PlannedLooks {
    std::vector<std::int64_t> looks;      ///< participants at each, rising; at least one
    Spending spending = Spending::kNone;  ///< kNone for one look only

    bool operator==(const PlannedLooks&) const = default;
};

/// What a study fixes before it has data, but the rule of exclusion.
struct StudyPlan {
    std::vector<PlannedHypothesis> hypotheses;  ///< in the study's order; empty: none are fixed
    std::optional<PlannedLooks> stopping = {};
    bool has_sides_by_trial = false;  ///< A and B change places within a session

    bool operator==(const StudyPlan&) const = default;
};

/// What is allowed, where the text of SessionRecord::study_plan is not such a plan: an object of
/// JSON as stimuli::Study::plan_json() writes it, or empty.
[[nodiscard]] std::optional<std::string> study_plan_problem(std::string_view text);

/// The plan of such a text, which fixes nothing where it is empty. Throws bad input that begins
/// with `where` for text that is no plan.
[[nodiscard]] StudyPlan study_plan(std::string_view text, std::string_view where);

}  // namespace obscura::analysis
