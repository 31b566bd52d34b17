// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/participants.h"

namespace obscura::analysis {

/// Draws participants anew and fills what intervals rest on them: HypothesisResult::resampled,
/// the intervals of ValidityResult::by_level that are not of the same participants and
/// VariantScale::resampled_jod; where there are none, with the reason.
void resample(Analysis& analysis, const VotesByParticipant& votes, std::uint64_t seed);

}  // namespace obscura::analysis
