// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/study_plan.h"
#include "analysis/tally.h"

namespace obscura::analysis {

/// Where the family of hypotheses was fixed.
enum class FamilyOrigin {
    kPlan,       ///< by the study, before it had data: every session carries it
    kBuiltIn,    ///< by this program, for the published votes and the built-in study
    kConditions  ///< by what each condition calls its hypothesis; each is primary
};

/// The hypotheses that are concluded on, in order of their ids; Holm's correction is over the tests
/// of those that are primary, whoever answered. At most one is an interaction.
struct Family {
    std::vector<PlannedHypothesis> hypotheses;
    FamilyOrigin origin = FamilyOrigin::kConditions;
    std::string words;  ///< where it was fixed, in a sentence

    /// The interaction, or nullptr.
    [[nodiscard]] const PlannedHypothesis* interaction() const;
};

[[nodiscard]] Family family_of(const Tally& tally);

}  // namespace obscura::analysis
