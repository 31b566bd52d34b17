// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/possible.h"
#include "analysis/store/records.h"

namespace obscura::analysis {

/// One vote, and who gave it.
struct Answer {
    std::int32_t participant = 0;  ///< number of the participant in the tally, from 0
    bool chose_b = false;
    bool b_second = false;  ///< B was shown second; has no meaning where Tally::order has no value
};

/// What one condition is, and the votes it got.
struct ConditionVotes {
    std::string id;
    std::string hypothesis;  ///< may be empty
    std::string validity;    ///< low, moderate or high
    std::string variant_a;
    std::string variant_b;
    Votes votes;
    std::vector<Answer> answers = {};  ///< each vote; empty where only the counts are known
};

/// Which image was chosen, by the order of showing.
struct OrderVotes {
    std::int64_t n = 0;
    std::int64_t second_chosen = 0;
};

/// What the tests start from.
struct Tally {
    std::string source;        ///< the store's URL or the file
    std::string study;         ///< empty: not known
    std::optional<Kind> kind;  ///< nothing: the counts do not say
    Possible<std::int64_t> n_participants = Possible<std::int64_t>::none("not counted");
    std::vector<ConditionVotes> conditions;
    Possible<OrderVotes> order = Possible<OrderVotes>::none("not counted");
};

/// Votes of the completed sessions of one kind (participant or simulated) of one study; practice,
/// catch and repeated trials never count. `study` may be empty when there is only one. Conditions
/// are in natural order of their names (C2 before C10). Throws bad input when no such session is
/// there (saying what there is instead), when several studies are there and none is named, and when
/// a condition has not the same variants, validity or hypothesis in all sessions.
[[nodiscard]] Tally tally_trials(const std::string& source,
                                 const std::vector<SessionRecord>& sessions,
                                 const std::vector<TrialRecord>& trials, const std::string& study,
                                 Kind kind);

}  // namespace obscura::analysis
