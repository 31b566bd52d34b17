// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// The votes of a tally by the participant who gave them.
class VotesByParticipant {
  public:
    struct Vote {
        std::uint32_t condition = 0;  ///< place in Tally::conditions
        std::uint32_t place = 0;      ///< in ConditionVotes::answers
    };

    /// Refers to `tally`, which must outlive it. Linear in the votes.
    explicit VotesByParticipant(const Tally& tally);

    [[nodiscard]] std::size_t participants() const { return begin_.size() - 1; }
    /// In order of conditions.
    [[nodiscard]] std::span<const Vote> of(std::size_t participant) const;
    [[nodiscard]] const Answer& answer(const Vote& vote) const {
        return tally_.conditions[vote.condition].answers[vote.place];
    }

  private:
    const Tally& tally_;
    std::vector<std::uint32_t> begin_;  ///< of each participant's votes, and the end
    std::vector<Vote> votes_;
};

/// How attentive and how fast each participant was, in the tally's order; a rule of exclusion is
/// applied to the attentive and the fast alike.
[[nodiscard]] Attention attention_of(const Tally& tally, const VotesByParticipant& votes);

/// Median response times, each participant with one time.
[[nodiscard]] Possible<ResponseTimes> response_times(const Tally& tally,
                                                     const VotesByParticipant& votes);

/// What changes over the session.
[[nodiscard]] Possible<Learning> learning_of(const Tally& tally, const VotesByParticipant& votes);

}  // namespace obscura::analysis
