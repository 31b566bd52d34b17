// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/participants.h"

namespace obscura::analysis {

/// Whether the order of showing influenced the answers. Where each participant saw the same side
/// first in every pair, the numbers of votes for B of the two groups are parted anew in all ways;
/// where the side varies, the signs of each participant's preference for the second image are
/// flipped. No value, with the reason, where nothing can be compared. The tally knows the order.
[[nodiscard]] Possible<OrderByParticipant> order_by_participant(const VotesByParticipant& votes);

}  // namespace obscura::analysis
